#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::score {

/// Three numbers that nobody tells.
inline Eigen::Vector3d untold() {
  return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

/// What a truth or somebody's estimate says of a vehicle at a time. A number that it does not say
/// is NaN, as is the variance of one; a covariance of which it says nothing is empty.
struct State {
  measurement::Stamp at{};
  Eigen::Vector3d position_ned = untold();  ///< m
  Eigen::Vector3d angles = untold();        ///< roll, pitch, heading, rad
  Eigen::Vector3d velocity = untold();      ///< over ground, m/s: NED, or as the next line says
  bool velocity_in_body = false;            ///< forward, right, down
  std::optional<Eigen::Matrix3d> position_m2{}, angles_rad2{}, velocity_m2ps2{};

  bool says_anything() const {
    return !position_ned.array().isNaN().all() || !angles.array().isNaN().all() ||
           !velocity.array().isNaN().all();
  }
};

/// In the order of time.
using Track = std::vector<State>;

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
