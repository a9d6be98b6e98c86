#include "estimators/velocity/coupled_navigation_body.hpp"

#include <cmath>

namespace drydock::velocity {

Eigen::Vector4d absence_prior(const CoupledOptions& o) {
  return {o.current_mps, o.current_mps, o.log_scale, o.log_bias_mps};
}

void weigh_absence_of_run(double* covariance, const double* values, const CoupledOptions& options,
                          double* errors) {
  using Filter = CoupledNavigation::Filter;
  Filter filter{Filter::Vector::Zero()};
  filter.covariance() = Eigen::Map<const Filter::Covariance>(covariance);
  Eigen::Map<Filter::Vector>{errors} =
      weigh_absence(filter, current_error, Eigen::Map<const Eigen::Vector4d>(values),
                    absence_prior(options))
          .errors;
  Eigen::Map<Filter::Covariance>{covariance} = filter.covariance();
}

template <>
bool CoupledNavigation::passes(double innovation, double variance) {
  const double square = innovation * innovation / variance;
  const bool outside = navigation::outside_gate(square, options_.navigation.gate_sigma);
  innovations_.push_back({-innovation, std::sqrt(variance), !outside});
  if (outside) {
    ++rejected_;
    return false;
  }
  taken_.add(square);
  return true;
}

template <>
bool CoupledNavigation::passes_height(double height_m) {
  const double variance =
      filter_.covariance()(navigation::position_error + 2, navigation::position_error + 2) +
      options_.depth_sigma_m * options_.depth_sigma_m;
  return passes(state().position.height_m - height_m, variance);
}

template class BasicCoupledNavigation<double>;

}  // namespace drydock::velocity
