#pragma once

#include <Eigen/Core>

#include "estimators/smoothing/track.hpp"

/// A vehicle without an inertial unit: it moves along its heading axes (ahead, starboard, down;
/// they turn with the heading and stay level) with accelerations that last for a while.
namespace drydock::smoothing {

/// First index of each part of the errors. Position in m north, east, down.
enum LevelError {
  position_part = 0,
  velocity_part = 3,
  heading_part = 6,
  turn_part = 7,
  bias_part = 8,
  current_part = 9,
  acceleration_part = 11,
  turn_change_part = 14,
  bottom_scale_part = 15,
  log_scale_part = 16,
  level_size = 17
};
using LevelVector = Eigen::Matrix<double, level_size, 1>;
using LevelMatrix = Eigen::Matrix<double, level_size, level_size>;

struct LevelState {
  frame::Position position;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< over ground, heading axes, m/s
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< of that, m/s2
  double heading_rad = 0, turn_radps = 0, turn_change_radps2 = 0;
  double heading_bias_rad = 0;                        ///< compass minus true heading
  Eigen::Vector2d current = Eigen::Vector2d::Zero();  ///< of the water, north, east, m/s
  double bottom_scale = 0, log_scale = 0;             ///< measured / true - 1

  void add(const LevelVector& correction);
};

/// How fast the state wanders: densities per sqrt(s), and how long an acceleration and a change of
/// the turn last. Chosen for vehicles of 1 to 10 m.
struct LevelMotion {
  double velocity_mps = 0.1, turn_radps = 0.02;
  double acceleration_s = 2, turn_change_s = 2;
  double heading_bias_rad = 0;
  double current_mps = 0.002;
};

/// Coordinates of a vector in heading axes -> NED.
Eigen::Matrix3d heading_to_ned(double heading_rad);
/// Coordinates of a vector in body axes -> heading axes.
Eigen::Matrix3d body_to_level(const Tilt& tilt);
/// How fast a place in the body moves by the rates of roll and pitch alone, heading axes, m/s.
Eigen::Vector3d moved_by_tilting(const Tilt& tilt, const Eigen::Vector3d& place);

/// Where the heading axes point on the mean of the next `dt`: heading axes -> NED.
Eigen::Matrix3d middle_axes(const LevelState& state, const LevelMotion& motion, double dt);
/// Moves the state by `dt` along such axes and returns the transition of its errors, eq. (S6).
LevelMatrix move(LevelState& state, const LevelMotion& motion, double dt,
                 const Eigen::Matrix3d& axes);
/// What `dt` adds to the covariance, eq. (S7).
LevelMatrix wandering(const LevelMotion& motion, double dt, const Eigen::Matrix3d& axes);

TrackPoint point_of(double time_s, const LevelState& state, const LevelMatrix& covariance,
                    const Tilt& tilt);

}  // namespace drydock::smoothing
