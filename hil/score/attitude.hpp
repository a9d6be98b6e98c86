#pragma once

#include "estimators/frame/attitude.hpp"
#include "hil/score/track.hpp"

namespace drydock::score {

/// Body to NED. Empty where an angle is not told.
inline std::optional<Eigen::Quaterniond> attitude_of(const State& state) {
  if (!state.angles.allFinite()) return {};
  return frame::body_to_ned({state.angles.x(), state.angles.y(), state.angles.z()});
}

inline Eigen::Vector3d angles_of(const Eigen::Quaterniond& body_to_ned) {
  const auto angles = frame::euler(body_to_ned);
  return {angles.roll, angles.pitch, angles.yaw};
}

/// The smallest turns between angles; NaN stays.
inline Eigen::Vector3d turns_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const auto wrapped = [](double angle) {
    return std::isnan(angle) ? angle : frame::wrap_pi(angle);
  };
  return (to - from).unaryExpr(wrapped);
}

/// How much roll, pitch, heading change with small turns about N, E, D.
inline Eigen::Matrix3d angles_by_turns(const Eigen::Vector3d& angles) {
  const frame::Euler attitude{angles.x(), angles.y(), angles.z()};
  const Eigen::Matrix3d to_body = frame::ned_to_body(attitude);
  Eigen::Matrix3d change;
  for (Eigen::Index i = 0; i < 3; ++i) change.col(i) = frame::euler_rates(attitude, to_body.col(i));
  return change;
}

}  // namespace drydock::score
