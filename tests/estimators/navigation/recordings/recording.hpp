#pragma once

#include <Eigen/Core>

namespace drydock::navigation::test {

/// The mean values of an IMU over the interval that ends at `t`, in its own axes.
struct ImuRow {
  double t;               ///< s, on the clock of the recording
  Eigen::Vector3d rate;   ///< rad/s
  Eigen::Vector3d force;  ///< m/s2
  /// One standard deviation of the error of a row that the logger lost; zero: it was not lost.
  Eigen::Vector3d rate_missed = Eigen::Vector3d::Zero(), force_missed = Eigen::Vector3d::Zero();
};

}  // namespace drydock::navigation::test
