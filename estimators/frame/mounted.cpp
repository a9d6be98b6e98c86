#include "estimators/frame/mounted.hpp"

#include <cmath>

namespace drydock::frame {

using Eigen::Vector3d;

Vector3d down_in_body(double roll_rad, double pitch_rad) {
  return {-std::sin(pitch_rad), std::sin(roll_rad) * std::cos(pitch_rad),
          std::cos(roll_rad) * std::cos(pitch_rad)};
}

/// The rows of these matrices are the axes of sensor and body in NED.
Euler of_body(const Euler& of_sensor, const Eigen::Matrix3d& sensor_to_body) {
  return euler(Eigen::Matrix3d(sensor_to_body * ned_to_body(of_sensor)));
}

/// Each heading is that of an axis x, seen from above.
double heading_beside_sensor(const Vector3d& down, const Eigen::Matrix3d& sensor_to_body) {
  const Vector3d sensor = sensor_to_body.col(0), body = Vector3d::UnitX();
  return std::atan2(down.dot(sensor.cross(body)),
                    sensor.dot(body) - sensor.dot(down) * body.dot(down));
}

}  // namespace drydock::frame
