#pragma once

#include <cmath>
#include <optional>

namespace drydock::characterize {

/// A figure with its 95 % confidence bounds.
struct Estimate {
  double value = 0;
  double low = 0, high = 0;

  bool holds(double x) const { return low <= x && x <= high; }
};

inline constexpr double z_95 = 1.959963984540054;  ///< two-sided quantile of N(0, 1)

/// An estimate with normal errors of standard deviation sigma.
inline Estimate normal_estimate(double value, double sigma) {
  return {value, value - z_95 * sigma, value + z_95 * sigma};
}

/// A standard deviation whose square was estimated as `variance` with the standard deviation
/// `sigma`: chi-square distributed with 2 (variance / sigma)^2 degrees of freedom.
Estimate deviation_estimate(double variance, double sigma);

}  // namespace drydock::characterize
