#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "hil/characterize/noise/noise_model.hpp"

namespace drydock::characterize {

/// Overlapping Allan variances of evenly spaced readings at 1, 2, 4, ... samples: every cluster of
/// m readings is compared with the next one, and a cluster starts at each reading. The longest
/// cluster fits into the recording at least nine times.
struct AllanCurve {
  double period_s = 0;  ///< time between readings
  std::size_t readings = 0;
  std::vector<std::size_t> samples;  ///< samples per cluster
  std::vector<double> variance;      ///< q^2

  double tau_s(std::size_t i) const { return static_cast<double>(samples[i]) * period_s; }
};

AllanCurve allan_curve(std::span<const double> readings, double period_s);

/// The covariance of the variances of such a curve if `model` is true. The variances are
/// correlated, because overlapping estimates share their readings. It is computed from the
/// generalised autocovariance of the integral (C. Greenhall, W. Riley, Uncertainty of Stability
/// Variances Based on Finite Differences, PTTI 2003), for Gaussian noise. Element (i, i) /
/// variance^2 is 2 / (degrees of freedom).
Eigen::MatrixXd covariance(const AllanCurve& curve, const NoiseModel& model);

}  // namespace drydock::characterize
