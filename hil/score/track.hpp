#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::score {

/// Where a vehicle was at a time, or where somebody says that it was.
struct Pose {
  measurement::Stamp at{};
  Eigen::Vector3d position_ned = Eigen::Vector3d::Zero();  ///< m
  std::optional<Eigen::Quaterniond> body_to_ned;           ///< body forward, right, down
  std::optional<Eigen::Matrix3d> covariance_m2;            ///< of the position, NED
};

/// In the order of time.
using Track = std::vector<Pose>;

/// What a file of estimates gives.
struct Estimates {
  Track track;
  std::vector<std::string> notes;  ///< what was passed over, for a person
};

/// Why a file gives no track.
struct Problem {
  std::string line;  ///< for a person: file, place, what is wrong
};

}  // namespace drydock::score
