#pragma once

#include <Eigen/Geometry>

namespace drydock::score {

/// East-north-up to north-east-down, and back.
inline const Eigen::Matrix3d enu_to_ned{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
/// Forward-left-up to forward-right-down, and back.
inline const Eigen::Matrix3d flu_to_frd{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};

/// From body (forward, left, up) to ENU, to body (forward, right, down) to NED.
inline Eigen::Quaterniond ned_of_enu(const Eigen::Quaterniond& flu_to_enu) {
  return Eigen::Quaterniond(enu_to_ned * flu_to_enu.normalized().toRotationMatrix() * flu_to_frd);
}

}  // namespace drydock::score
