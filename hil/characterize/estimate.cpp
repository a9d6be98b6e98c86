#include "hil/characterize/estimate.hpp"

#include <boost/math/distributions/chi_squared.hpp>

namespace drydock::characterize {

Estimate deviation_estimate(double variance, double sigma) {
  const double value = std::sqrt(variance);
  if (!(sigma > 0)) return {value, value, value};
  const double freedom = 2 * (variance / sigma) * (variance / sigma);
  const boost::math::chi_squared distribution(freedom);
  constexpr double tail = 0.025;
  return {value, std::sqrt(variance * freedom / quantile(complement(distribution, tail))),
          std::sqrt(variance * freedom / quantile(distribution, tail))};
}

}  // namespace drydock::characterize
