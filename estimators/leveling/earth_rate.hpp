#pragma once

#include <Eigen/Core>

namespace drydock::leveling {

/// The Earth's rate and its uncertainty for a filter that does not measure the heading: eq. (16),
/// (A7), (A11) of docs/estimators/leveling.md.
class EarthRate {
 public:
  explicit EarthRate(double latitude_rad);

  /// The vehicle turned while no gyro measured it, by an angle of this standard deviation.
  void forget_heading(double sigma_rad);

  /// The heading was carried for `dt` seconds by a gyro with a constant bias of this standard
  /// deviation, rad/s, (A11). Gives how much variance() grew.
  double drift(double gyro_bias_sigma_radps, double dt);

  /// The expected rate, rad/s. North is given by the heading that the filter carries.
  const Eigen::Vector3d& ned() const { return expected_; }
  /// Variance of each horizontal component, rad2/s2, from the uncertain heading.
  double variance() const { return variance_; }

 private:
  void expect();

  Eigen::Vector3d given_, expected_;
  double forgotten_variance_ = 0, drift_rad_ = 0;  ///< of the heading
  double variance_ = 0;
};

}  // namespace drydock::leveling
