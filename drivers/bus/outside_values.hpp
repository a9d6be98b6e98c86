#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::bus {

/// What a message of another program's estimator says, in Drydock's axes and SI units. A part that
/// the message does not have, or whose covariance is not known, is empty.
struct OutsideValues {
  measurement::Stamp valid_at{};
  std::optional<Eigen::Quaterniond> body_to_ned;
  std::optional<Eigen::Vector3d> offset_ned_m;  ///< from the origin of the program's axes
  std::optional<Eigen::Vector3d> geodetic;      ///< latitude, longitude rad, height m
  std::optional<Eigen::Vector3d> velocity_ned_mps;
  std::optional<Eigen::Matrix3d> rotation_rad2;                ///< about N, E, D
  std::optional<Eigen::Matrix3d> position_m2, velocity_m2ps2;  ///< NED
};

}  // namespace drydock::bus
