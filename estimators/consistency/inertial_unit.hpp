#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "estimators/consistency/sensor.hpp"
#include "estimators/consistency/track.hpp"

namespace drydock::consistency {

/// The sums of one inertial unit, and its attitude against the horizon: the direction of gravity is
/// turned with the rates and pulled slowly to what specific force and acceleration say. The Earth's
/// turn, which the gyros feel too, is learned in axes that keep their heading.
class InertialUnit {
 public:
  InertialUnit(std::uint16_t device, const Sensor& sensor);

  void take(const measurement::ImuSample& sample);

  /// Moves on to `at`. False: there are no samples around it, or not all of those since the last
  /// step. Over a short hole the level turns on by the rates on both sides of it.
  bool advance(Stamp at);

  /// Eq. (8): how much the specific force differs from acceleration less gravity, m/s2, body.
  /// Then pulls the direction of gravity, if `pull`. `acceleration`: of the vehicle against the
  /// ground, body.
  Eigen::Vector3d level(const Eigen::Vector3d& acceleration, bool pull);

  /// The difference of a level that is pulled all the time, with 3 s: a gyro's fault that lasts
  /// shows in it, a fault that is over does not.
  double quick_difference() const { return quick_difference_.norm(); }
  /// Its errors are those of its short mean, so the pull is quick again.
  void take_quick_level();

  /// The body's heading by all devices. The level axes keep theirs by it, so a fault of the unit
  /// does not turn them.
  void follow_heading(double heading);
  /// Two level axes at right angles, in the body; they keep their heading while it turns. Empty:
  /// the body stands on its nose or tail.
  std::optional<Eigen::Matrix<double, 3, 2>> level_axes() const;

  std::uint16_t device() const { return device_; }
  const Eigen::Vector3d& rate() const { return rate_; }    ///< rad/s, mean of the last step
  const Eigen::Vector3d& force() const { return force_; }  ///< m/s2, the same of specific force
  const Eigen::Vector3d& down() const { return down_; }    ///< unit vector, body
  /// The unit was away, and nothing turned its level meanwhile: the next level() finds it anew.
  void lose_level();
  bool level_lost() const { return level_lost_; }
  /// The level is a long mean. Behind a fault it is not, for a while.
  bool settled() const;
  /// 1 sigma of a level that was found anew and is a short mean yet, rad.
  double level_sigma() const;
  double heading() const { return heading_; }  ///< rad, integrated from 0
  std::uint64_t serial() const { return serial_; }
  bool running() const { return running_; }  ///< the last step had all its samples
  /// The first step behind a hole: what was integrated over it is a guess.
  bool resumed() const { return running_ && holed_; }
  const Freeze& freeze() const { return freeze_; }

 private:
  using Sums = Eigen::Matrix<double, 8, 1>;
  void begin(Stamp at, const Sums& sums);
  void turn(double dt);
  void note_unknown_turn(double variance);
  void learn_earth_turn(const Eigen::Vector3d& difference);

  std::uint16_t device_;
  std::chrono::nanoseconds longest_gap_, hole_;
  /// Of rate and specific force over time, the time without holes, and the square of what the body
  /// may have turned in holes otherwise than it seems; about 40 a second.
  Track<8, 64> sums_;
  Sums sum_ = Sums::Zero(), at_last_ = Sums::Zero();
  Eigen::Vector3d last_rate_ = Eigen::Vector3d::Zero(), last_force_ = Eigen::Vector3d::Zero();
  Stamp last_sample_{}, next_push_{}, last_{};
  bool begun_ = false, running_ = false, holed_ = false, level_lost_ = false;
  bool level_anew_ = false;  ///< it was found anew once
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero(), force_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d down_ = Eigen::Vector3d::UnitZ(), middle_ = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d quick_ = Eigen::Vector3d::UnitZ(), quick_difference_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d earth_turn_ = Eigen::Vector2d::Zero();  ///< rad/s, level_axes
  double heading_ = 0, levelled_s_ = 0, dt_ = 0;
  double axes_heading_ = 0;    ///< rad, of level_axes
  double level_variance_ = 0;  ///< rad2, of turns in holes that the pull has not undone
  double cos_heading_ = 1, sin_heading_ = 0;
  std::uint64_t serial_ = 0;
  Freeze freeze_;
};

}  // namespace drydock::consistency
