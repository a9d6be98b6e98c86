#pragma once

#include "estimators/frame/attitude.hpp"

/// Angles of a body from those of a sensor that is mounted turned. `sensor_to_body` converts
/// coordinates.
namespace drydock::frame {

/// Direction of gravity in a body with these angles.
Eigen::Vector3d down_in_body(double roll_rad, double pitch_rad);

/// Attitude of the body. Its roll and pitch do not depend on the yaw of the sensor.
Euler of_body(const Euler& of_sensor, const Eigen::Matrix3d& sensor_to_body);

/// Heading of the body less that of the sensor, rad, (-pi, pi]. It depends on the tilt of the body:
/// `down` is the direction of gravity in it, a unit vector.
double heading_beside_sensor(const Eigen::Vector3d& down, const Eigen::Matrix3d& sensor_to_body);

}  // namespace drydock::frame
