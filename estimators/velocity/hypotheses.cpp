#include "estimators/velocity/hypotheses.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

namespace drydock::velocity {

namespace {

using Filter = navigation::ErrorFilter<7>;

/// The filter under the condition that some of its states are zero.
struct Conditioned {
  double log_weight = 0;  ///< relative to no condition, eq. (V8)
  Filter::Vector errors = Filter::Vector::Zero();
  Filter::Covariance covariance;
};

/// Conditions on one zero after the other. The weight is the product of the ratios of two densities
/// at zero: the posterior, given the zeros before, over the prior.
Conditioned with_zeros(Filter filter, int first, const Eigen::Vector4d& values,
                       const Eigen::Vector4d& prior_sigma, const std::array<bool, 2>& absent) {
  Conditioned result;
  for (int i = 0; i < 4; ++i) {
    if (!absent[static_cast<std::size_t>(i / 2)]) continue;
    const auto row = filter.row(Filter::Vector::Unit(first + i), 0);
    const double value = values(i) - result.errors(first + i);
    const double prior = prior_sigma(i) * prior_sigma(i);
    if (!(row.variance > 1e-12 * prior)) continue;  // already known to be zero
    result.log_weight += 0.5 * (std::log(prior / row.variance) - value * value / row.variance);
    result.errors += filter.update(row, value);
  }
  result.covariance = filter.covariance();
  return result;
}

}  // namespace

Weighed weigh_absence(Filter& filter, int first, const Eigen::Vector4d& values,
                      const Eigen::Vector4d& prior_sigma) {
  std::array<Conditioned, 4> hypotheses;
  double best = 0;
  for (std::size_t h = 0; h < 4; ++h) {
    hypotheses[h] = with_zeros(filter, first, values, prior_sigma, {(h & 1) != 0, (h & 2) != 0});
    best = std::max(best, hypotheses[h].log_weight);
  }
  std::array<double, 4> weight;
  double sum = 0;
  for (std::size_t h = 0; h < 4; ++h) sum += weight[h] = std::exp(hypotheses[h].log_weight - best);

  Weighed mixture{Filter::Vector::Zero(), {0, 0}};
  for (std::size_t h = 0; h < 4; ++h) {
    weight[h] /= sum;
    mixture.errors += weight[h] * hypotheses[h].errors;
    if (h & 1) mixture.absent[0] += weight[h];
    if (h & 2) mixture.absent[1] += weight[h];
  }
  Filter::Covariance covariance = Filter::Covariance::Zero();
  for (std::size_t h = 0; h < 4; ++h) {
    const Filter::Vector off = hypotheses[h].errors - mixture.errors;
    covariance += weight[h] * (hypotheses[h].covariance + off * off.transpose());
  }
  filter.covariance() = covariance;
  return mixture;
}

}  // namespace drydock::velocity
