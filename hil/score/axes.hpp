#pragma once

#include <Eigen/Geometry>

namespace drydock::score {

/// East-north-up to north-east-down, and back.
inline Eigen::Vector3d ned_of_enu(const Eigen::Vector3d& v) { return {v.y(), v.x(), -v.z()}; }

inline Eigen::Matrix3d ned_of_enu(const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d swap{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
  return swap * covariance * swap.transpose();
}

/// From body (forward, left, up) to ENU, to body (forward, right, down) to NED.
inline Eigen::Quaterniond ned_of_enu(const Eigen::Quaterniond& flu_to_enu) {
  const Eigen::Matrix3d swap{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
  const Eigen::Matrix3d flip = Eigen::Vector3d{1, -1, -1}.asDiagonal();
  return Eigen::Quaterniond(swap * flu_to_enu.normalized().toRotationMatrix() * flip);
}

}  // namespace drydock::score
