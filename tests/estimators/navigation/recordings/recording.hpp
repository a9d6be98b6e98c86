#pragma once

#include <Eigen/Core>

namespace drydock::navigation::test {

/// What an IMU measured over the interval that ends at `t`, in its own axes.
struct ImuRow {
  double t;               ///< s, in the recording's own count
  Eigen::Vector3d rate;   ///< rad/s
  Eigen::Vector3d force;  ///< m/s2
  /// One standard deviation of what is wrong with a row the logger lost; zero: it did not.
  Eigen::Vector3d rate_missed = Eigen::Vector3d::Zero(), force_missed = Eigen::Vector3d::Zero();
};

}  // namespace drydock::navigation::test
