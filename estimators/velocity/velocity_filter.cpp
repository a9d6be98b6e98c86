#include "estimators/velocity/velocity_filter_body.hpp"

#include <cmath>

namespace drydock::velocity {

template <>
bool VelocityFilter::passes(const double& residual, const double& innovation_variance) {
  const double square = residual * residual / innovation_variance;
  const bool outside =
      options_.gate_sigma > 0 && square > options_.gate_sigma * options_.gate_sigma;
  innovations_.push_back({residual, std::sqrt(innovation_variance), !outside});
  if (outside) {
    ++rejected_;
    return false;
  }
  taken_.add(square);
  return true;
}

template class BasicVelocityFilter<double>;

}  // namespace drydock::velocity
