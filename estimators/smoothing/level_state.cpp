#include "estimators/smoothing/level_state.hpp"

#include <cmath>

#include "estimators/frame/earth.hpp"

namespace drydock::smoothing {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

void move_by(frame::Position& position, const Vector3d& ned) {
  const double meridian = frame::meridian_radius(position.latitude_rad) + position.height_m;
  const double transverse = frame::transverse_radius(position.latitude_rad) + position.height_m;
  position.longitude_rad += ned.y() / (transverse * std::cos(position.latitude_rad));
  position.longitude_rad = frame::wrap_pi(position.longitude_rad);
  position.latitude_rad += ned.x() / meridian;
  position.height_m -= ned.z();
}

/// d(NED velocity) by the heading.
Vector3d turned(double heading_rad, const Vector3d& v) {
  const double s = std::sin(heading_rad), c = std::cos(heading_rad);
  return {-s * v.x() - c * v.y(), c * v.x() - s * v.y(), 0};
}

}  // namespace

void LevelState::add(const LevelVector& correction) {
  move_by(position, correction.segment<3>(position_part));
  velocity += correction.segment<3>(velocity_part);
  heading_rad = frame::wrap_pi(heading_rad + correction(heading_part));
  turn_radps += correction(turn_part);
  heading_bias_rad += correction(bias_part);
  current += correction.segment<2>(current_part);
}

Matrix3d heading_to_ned(double heading_rad) {
  const double s = std::sin(heading_rad), c = std::cos(heading_rad);
  return (Matrix3d() << c, -s, 0, s, c, 0, 0, 0, 1).finished();
}

Matrix3d body_to_level(const Tilt& tilt) {
  return frame::body_to_ned({tilt.roll_rad, tilt.pitch_rad, 0}).toRotationMatrix();
}

LevelMatrix move(LevelState& state, double dt) {
  const double middle = state.heading_rad + state.turn_radps * dt / 2;
  const Matrix3d axes = heading_to_ned(middle);
  const Vector3d by_heading = turned(middle, state.velocity) * dt;
  LevelMatrix transition = LevelMatrix::Identity();
  transition.block<3, 3>(position_part, velocity_part) = axes * dt;
  transition.block<3, 1>(position_part, heading_part) = by_heading;
  transition.block<3, 1>(position_part, turn_part) = by_heading * dt / 2;
  transition(heading_part, turn_part) = dt;
  move_by(state.position, axes * state.velocity * dt);
  state.heading_rad = frame::wrap_pi(state.heading_rad + state.turn_radps * dt);
  return transition;
}

LevelMatrix wandering(const LevelState& state, const LevelMotion& motion, double dt) {
  const double v = motion.velocity_mps * motion.velocity_mps;
  const double turn = motion.turn_radps * motion.turn_radps;
  LevelMatrix q = LevelMatrix::Zero();
  const Matrix3d axes = heading_to_ned(state.heading_rad);
  q.block<3, 3>(position_part, position_part).diagonal().array() = v * dt * dt * dt / 3;
  q.block<3, 3>(position_part, velocity_part) = v * dt * dt / 2 * axes;
  q.block<3, 3>(velocity_part, position_part) = v * dt * dt / 2 * axes.transpose();
  q.block<3, 3>(velocity_part, velocity_part).diagonal().array() = v * dt;
  q(heading_part, heading_part) = turn * dt * dt * dt / 3;
  q(heading_part, turn_part) = q(turn_part, heading_part) = turn * dt * dt / 2;
  q(turn_part, turn_part) = turn * dt;
  q(bias_part, bias_part) = motion.heading_bias_rad * motion.heading_bias_rad * dt;
  q.diagonal().segment<2>(current_part).array() = motion.current_mps * motion.current_mps * dt;
  return q;
}

TrackPoint point_of(double time_s, const LevelState& state, const LevelMatrix& covariance,
                    const Tilt& tilt) {
  const Matrix3d axes = heading_to_ned(state.heading_rad);
  Eigen::Matrix<double, 3, 4> by_errors;  // of the NED velocity, by velocity and heading
  by_errors << axes, turned(state.heading_rad, state.velocity);
  TrackPoint point;
  point.time_s = time_s;
  point.position = state.position;
  point.velocity_ned = axes * state.velocity;
  point.attitude = {tilt.roll_rad, tilt.pitch_rad, state.heading_rad};
  point.position_covariance = covariance.block<3, 3>(position_part, position_part);
  point.velocity_covariance =
      by_errors * covariance.block<4, 4>(velocity_part, velocity_part) * by_errors.transpose();
  point.heading_sigma_rad = std::sqrt(covariance(heading_part, heading_part));
  return point;
}

}  // namespace drydock::smoothing
