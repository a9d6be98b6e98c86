#pragma once

#include <Eigen/Core>

#include "rig_config/rig.hpp"

namespace drydock::sensor {

/// The attitude of a sensor relative to the body, and its place in the body frame.
struct Mounting {
  Eigen::Matrix3d sensor_to_body = Eigen::Matrix3d::Identity();
  Eigen::Vector3d lever_arm_m = Eigen::Vector3d::Zero();

  Eigen::Vector3d to_sensor(const Eigen::Vector3d& in_body) const {
    return sensor_to_body.transpose() * in_body;
  }
};

/// mounting_rad turns the body's axes by yaw, then pitch, then roll into the sensor's axes.
Mounting mounting_of(const rig_config::DeviceConfig& config);

}  // namespace drydock::sensor
