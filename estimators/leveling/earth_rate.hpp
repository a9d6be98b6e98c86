#pragma once

#include <Eigen/Core>

namespace drydock::leveling {

/// The Earth's rate as far as a filter that does not measure its heading knows it: eq. (16), (A7)
/// of docs/estimators/leveling.md.
class EarthRate {
 public:
  explicit EarthRate(double latitude_rad);

  /// The vehicle turned unseen, by an angle of this standard deviation.
  void forget_heading(double sigma_rad);

  /// What to expect, rad/s; north is that of the carried heading.
  const Eigen::Vector3d& ned() const { return expected_; }
  /// Of each horizontal component, rad2/s2: what the heading leaves open.
  double variance() const { return variance_; }

 private:
  Eigen::Vector3d given_, expected_;
  double heading_variance_ = 0, variance_ = 0;
};

}  // namespace drydock::leveling
