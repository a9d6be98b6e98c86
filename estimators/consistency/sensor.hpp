#pragma once

#include <Eigen/Core>

#include "drivers/measurement/kind.hpp"

namespace drydock::consistency {

/// What the checks know beforehand about one device of the rig.
struct Sensor {
  measurement::Kind kind = measurement::Kind::imu;
  double rate_hz = 1;
  Eigen::Vector3d lever_arm_m = Eigen::Vector3d::Zero();         ///< body, from the origin
  Eigen::Matrix3d sensor_to_body = Eigen::Matrix3d::Identity();  ///< of its mounting
  bool of_thruster = false;  ///< actuator: its turns alone do not make the speed
};

}  // namespace drydock::consistency
