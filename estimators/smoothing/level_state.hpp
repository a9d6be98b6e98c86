#pragma once

#include <Eigen/Core>

#include "estimators/smoothing/track.hpp"

/// A vehicle without an inertial unit: it moves along its heading axes (ahead, starboard, down;
/// they turn with the heading and stay level) with a velocity and a rate of turn that wander.
namespace drydock::smoothing {

/// First index of each part of the errors. Position in m north, east, down.
enum LevelError {
  position_part = 0,
  velocity_part = 3,
  heading_part = 6,
  turn_part = 7,
  bias_part = 8,
  current_part = 9,
  level_size = 11
};
using LevelVector = Eigen::Matrix<double, level_size, 1>;
using LevelMatrix = Eigen::Matrix<double, level_size, level_size>;

struct LevelState {
  frame::Position position;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< over ground, heading axes, m/s
  double heading_rad = 0, turn_radps = 0;
  double heading_bias_rad = 0;                        ///< compass minus true heading
  Eigen::Vector2d current = Eigen::Vector2d::Zero();  ///< of the water, north, east, m/s

  void add(const LevelVector& correction);
};

/// How fast the state wanders: densities per sqrt(s). Chosen for vehicles of 1 to 10 m.
struct LevelMotion {
  double velocity_mps = 0.1, turn_radps = 0.02;
  double heading_bias_rad = 0;
  double current_mps = 0.002;
};

/// Coordinates of a vector in heading axes -> NED.
Eigen::Matrix3d heading_to_ned(double heading_rad);
/// Coordinates of a vector in body axes -> heading axes.
Eigen::Matrix3d body_to_level(const Tilt& tilt);

/// Moves the state by `dt` and returns the transition of its errors, eq. (S6).
LevelMatrix move(LevelState& state, double dt);
/// What `dt` adds to the covariance, eq. (S7).
LevelMatrix wandering(const LevelState& state, const LevelMotion& motion, double dt);

TrackPoint point_of(double time_s, const LevelState& state, const LevelMatrix& covariance,
                    const Tilt& tilt);

}  // namespace drydock::smoothing
