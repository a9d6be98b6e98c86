#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "estimators/frame/geodetic.hpp"
#include "estimators/pipeline/estimate.hpp"

namespace drydock::pipeline {

/// The steady current that a filter estimates, with one standard deviation of each component.
struct CurrentEstimate {
  Eigen::Vector2d north_east_mps = Eigen::Vector2d::Zero(), sigma_mps = Eigen::Vector2d::Zero();
};

/// Position, velocity and attitude of the origin of the vehicle, with their covariance.
struct NavigationEstimate {
  using Covariance = Eigen::Matrix<double, 9, 9>;

  Stamp valid_at{};
  std::uint16_t estimator = 0;  ///< index in the rig
  frame::Position position;
  Eigen::Vector3d velocity_ned = Eigen::Vector3d::Zero();  ///< m/s over ground
  Eigen::Quaterniond body_to_ned = Eigen::Quaterniond::Identity();
  /// Covariance of position (north, east, down, m), velocity (NED, m/s) and rotation about N, E, D
  /// (rad).
  Covariance covariance = Covariance::Zero();
  std::optional<CurrentEstimate> current;  ///< empty if not estimated
  std::uint32_t fed_by = 0;                ///< bit i: device i of the rig has contributed
  Integrity integrity;
};

/// Covariance of roll, pitch and yaw, rad2, from that of the rotation about N, E, D. Not defined at
/// pitch +-pi/2.
Eigen::Matrix3d euler_covariance(const NavigationEstimate& estimate);

/// Only the attitude of the estimate.
AttitudeEstimate attitude_of(const NavigationEstimate& estimate);

}  // namespace drydock::pipeline
