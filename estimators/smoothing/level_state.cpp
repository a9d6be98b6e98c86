#include "estimators/smoothing/level_state.hpp"

#include <array>
#include <cmath>

#include "estimators/frame/earth.hpp"
#include "estimators/smoothing/singer.hpp"

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
Vector3d turned(const Matrix3d& axes, const Vector3d& v) {
  return axes * Vector3d(-v.y(), v.x(), 0);
}

double turned_over(const LevelState& state, const LevelMotion& motion, double dt) {
  const auto about = singer_step(motion.turn_radps, motion.turn_change_s, dt).transition;
  return state.turn_radps * dt + state.turn_change_radps2 * about(0, 2);
}

}  // namespace

void LevelState::add(const LevelVector& correction) {
  move_by(position, correction.segment<3>(position_part));
  velocity += correction.segment<3>(velocity_part);
  heading_rad = frame::wrap_pi(heading_rad + correction(heading_part));
  turn_radps += correction(turn_part);
  heading_bias_rad += correction(bias_part);
  current += correction.segment<2>(current_part);
  acceleration += correction.segment<3>(acceleration_part);
  turn_change_radps2 += correction(turn_change_part);
  bottom_scale += correction(bottom_scale_part);
  log_scale += correction(log_scale_part);
}

Matrix3d heading_to_ned(double heading_rad) {
  const double s = std::sin(heading_rad), c = std::cos(heading_rad);
  return (Matrix3d() << c, -s, 0, s, c, 0, 0, 0, 1).finished();
}

Matrix3d body_to_level(const Tilt& tilt) {
  return frame::body_to_ned({tilt.roll_rad, tilt.pitch_rad, 0}).toRotationMatrix();
}

Vector3d moved_by_tilting(const Tilt& tilt, const Vector3d& place) {
  const Matrix3d level = body_to_level(tilt);
  const Vector3d by_roll = tilt.roll_radps * Vector3d::UnitX().cross(place);
  return level * by_roll + tilt.pitch_radps * Vector3d::UnitY().cross(level * place);
}

Matrix3d middle_axes(const LevelState& state, const LevelMotion& motion, double dt) {
  return heading_to_ned(state.heading_rad + turned_over(state, motion, dt) / 2);
}

LevelMatrix move(LevelState& state, const LevelMotion& motion, double dt, const Matrix3d& axes) {
  const auto along = singer_step(motion.velocity_mps, motion.acceleration_s, dt).transition;
  const auto about = singer_step(motion.turn_radps, motion.turn_change_s, dt).transition;
  const double turned_rad = turned_over(state, motion, dt);
  const Vector3d way = state.velocity * dt + state.acceleration * along(0, 2);
  const Vector3d by_heading = turned(axes, way);
  LevelMatrix transition = LevelMatrix::Identity();
  transition.block<3, 3>(position_part, velocity_part) = axes * dt;
  transition.block<3, 3>(position_part, acceleration_part) = axes * along(0, 2);
  transition.block<3, 1>(position_part, heading_part) = by_heading;
  transition.block<3, 1>(position_part, turn_part) = by_heading * dt / 2;
  transition.block<3, 1>(position_part, turn_change_part) = by_heading * about(0, 2) / 2;
  transition.block<3, 3>(velocity_part, acceleration_part) = along(1, 2) * Matrix3d::Identity();
  transition.block<3, 3>(acceleration_part, acceleration_part) = along(2, 2) * Matrix3d::Identity();
  transition(heading_part, turn_part) = dt;
  transition(heading_part, turn_change_part) = about(0, 2);
  transition(turn_part, turn_change_part) = about(1, 2);
  transition(turn_change_part, turn_change_part) = about(2, 2);
  move_by(state.position, axes * way);
  state.heading_rad = frame::wrap_pi(state.heading_rad + turned_rad);
  state.velocity += along(1, 2) * state.acceleration;
  state.acceleration *= along(2, 2);
  state.turn_radps += about(1, 2) * state.turn_change_radps2;
  state.turn_change_radps2 *= about(2, 2);
  return transition;
}

LevelMatrix wandering(const LevelMotion& motion, double dt, const Matrix3d& axes) {
  const auto along = singer_step(motion.velocity_mps, motion.acceleration_s, dt).noise;
  const auto about = singer_step(motion.turn_radps, motion.turn_change_s, dt).noise;
  LevelMatrix q = LevelMatrix::Zero();
  constexpr std::array moved{position_part, velocity_part, acceleration_part};
  constexpr std::array swung{heading_part, turn_part, turn_change_part};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto to = static_cast<std::size_t>(i), from = static_cast<std::size_t>(j);
      // Positions are in NED, their rates in heading axes.
      const Matrix3d turn = i == 0 && j > 0   ? axes
                            : j == 0 && i > 0 ? Matrix3d(axes.transpose())
                                              : Matrix3d(Matrix3d::Identity());
      q.block<3, 3>(moved[to], moved[from]) = along(i, j) * turn;
      q(swung[to], swung[from]) = about(i, j);
    }
  q(bias_part, bias_part) = motion.heading_bias_rad * motion.heading_bias_rad * dt;
  q.diagonal().segment<2>(current_part).array() = motion.current_mps * motion.current_mps * dt;
  return q;
}

TrackPoint point_of(double time_s, const LevelState& state, const LevelMatrix& covariance,
                    const Tilt& tilt) {
  const Matrix3d axes = heading_to_ned(state.heading_rad);
  Eigen::Matrix<double, 3, 4> by_errors;  // of the NED velocity, by velocity and heading
  by_errors << axes, turned(axes, state.velocity);
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
