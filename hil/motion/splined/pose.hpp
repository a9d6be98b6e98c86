#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "estimators/frame/geodetic.hpp"

namespace drydock::motion {

/// Where a vehicle was, and how it lay, at one time of a track.
struct Pose {
  double t_s = 0;  ///< since the first pose
  frame::Position position;
  Eigen::Quaterniond body_to_ned = Eigen::Quaterniond::Identity();
};

using Poses = std::vector<Pose>;

}  // namespace drydock::motion
