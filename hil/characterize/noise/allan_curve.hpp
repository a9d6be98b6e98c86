#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "hil/characterize/noise/noise_model.hpp"

namespace drydock::characterize {

/// Overlapping Allan variances of evenly spaced readings at 1, 2, 4, ... samples: every cluster of
/// m readings against the one behind it, starting at each reading. At least nine clusters would fit
/// side by side into the longest.
struct AllanCurve {
  double period_s = 0;  ///< of the readings
  std::size_t readings = 0;
  std::vector<std::size_t> samples;  ///< in a cluster
  std::vector<double> variance;      ///< q^2

  double tau_s(std::size_t i) const { return static_cast<double>(samples[i]) * period_s; }
};

AllanCurve allan_curve(std::span<const double> readings, double period_s);

/// How the variances of such a curve scatter about those of `model`, and together with each other:
/// overlapping estimates share their readings. From the generalised autocovariance of the integral
/// (C. Greenhall, W. Riley, Uncertainty of Stability Variances Based on Finite Differences, PTTI
/// 2003), for Gaussian noise. Element (i, i) / variance^2 is 2 / (degrees of freedom).
Eigen::MatrixXd covariance(const AllanCurve& curve, const NoiseModel& model);

}  // namespace drydock::characterize
