#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimators/external/gives.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::external {

/// The parts of an estimate from outside, as far as it has them. SI units, radians; the covariance
/// of the attitude is that of roll, pitch and heading.
struct Values {
  measurement::Stamp valid_at{};
  std::optional<Eigen::Vector3d> roll_pitch_heading_rad;  ///< heading may be NaN: not given
  std::optional<frame::Position> position;                ///< height may be NaN: not given
  std::optional<Eigen::Vector3d> velocity_ned_mps;
  std::optional<Eigen::Matrix3d> attitude_rad2, position_m2, velocity_m2ps2;
  bool valid = true;
};

/// What is not given is NaN, and so is its covariance; then its bounds are infinite.
pipeline::OutsideEstimate estimate_of(const Values& values, Gives gives);

/// From its covariance; what is not known has no bound, or an infinite one.
void set_bounds(pipeline::NavigationEstimate& estimate);

}  // namespace drydock::external
