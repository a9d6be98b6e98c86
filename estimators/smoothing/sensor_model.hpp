#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace drydock::smoothing {

/// How one device stands in the vehicle and how it errs. Its readings are
///   (1 + scale_error) R(misalignment)' v  for velocities,
///   h + a + b sin h + c cos h             for headings,
/// and they were true `latency_s` before their time.
struct SensorModel {
  Eigen::Vector3d lever = Eigen::Vector3d::Zero();  ///< from the origin, body axes, m
  double pitch_rad = 0, yaw_rad = 0;                ///< mounting beyond that of the rig file
  double scale_error = 0;
  double latency_s = 0;
  std::array<double, 3> deviation_rad{};  ///< a, b, c
};

/// By index of the device.
using SensorModels = std::vector<SensorModel>;

}  // namespace drydock::smoothing
