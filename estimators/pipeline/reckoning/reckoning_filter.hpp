#pragma once

#include <Eigen/Core>
#include <array>

#include "estimators/navigation/innovation.hpp"

namespace drydock::pipeline {

/// How well speed and heading are known, one standard deviation each.
struct ReckoningErrors {
  double position_m = 10;         ///< of the start, each of north and east
  double heading_rad = 0.0175;    ///< of the heading's constant part
  double scale = 0.005;           ///< of the DVL's speed: scale factor, speed of sound
  double current_mps = 0.2;       ///< of the water, each of north and east, until it is measured
  double velocity_mps = 0.02;     ///< of a speed over ground, each sample
  double water_speed_mps = 0.05;  ///< of a speed through the water, each sample
  double wander = 0.1;            ///< of the speed between two samples, m/s per root second
};

/// What a way has of errors beside those of the state.
struct WayNoise {
  double wandered_m2 = 0;  ///< of the speed between its samples, each of north and east
  double aside_mps = 0;    ///< of a heading that was not measured at that time
  double aside_s = 0;      ///< for so long that error stays the same
  double wrong_mps = 0;    ///< of a device in doubt: a constant error
};

/// What a speed is measured against.
enum class SpeedOver : std::uint8_t { ground, water };

/// The errors of a horizontal track that is the sum of speed times time: north, east (m), heading
/// (rad), scale, current (m/s) along the north and the east that the measured heading shows, and
/// their covariance. docs/estimators/dead-reckoning.md
class ReckoningFilter {
 public:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  explicit ReckoningFilter(const ReckoningErrors& errors);

  /// The velocity over ground, north and east, that a measured one means with the errors known so
  /// far.
  Eigen::Vector2d over_ground(const Eigen::Vector2d& measured, SpeedOver over) const;
  /// The measured velocity that means this one over ground.
  Eigen::Vector2d as_measured(const Eigen::Vector2d& ground, SpeedOver over) const;
  /// The vehicle moved for `dt` with this mean velocity (as measured). Returns the way, north and
  /// east, m. Eqs. (1) to (3).
  Eigen::Vector2d move(const Eigen::Vector2d& mean, double dt, SpeedOver over,
                       const WayNoise& noise);
  /// The variance of a way of `dt` by the wander between two known speeds, and behind one, m2.
  double wandered_between(double dt) const;
  double wandered_behind(double dt) const;
  /// The same instant's speed over ground and through the water, as measured: shows the current.
  /// Eq. (4). Speeds beyond the gate of 6 sigmas change nothing.
  navigation::Innovations compare(const Eigen::Vector2d& ground, const Eigen::Vector2d& water);
  /// A position that lies at `offset` of the track's, north and east, m. Returns the innovations;
  /// takes the offset's used part out of `offset`, so that it is the step of the position. One
  /// beyond the gate changes nothing: its step is zero.
  navigation::Innovations fix(Eigen::Vector2d& offset, double sigma_m);

  /// The position is that of a fix now.
  void begin_at_fix(double sigma_m);
  /// A fix lies so far from the track, and is right: so heading and current are as at the start.
  void loosen(double position_m);
  /// The heading may have a constant error of so much more than at the start; 0: no more.
  void doubt_heading(double rad);
  /// The current has changed by so much.
  void loosen_current(double mps);

  const Matrix6& covariance() const { return covariance_; }
  /// North and east, m/s.
  Eigen::Vector2d current() const;
  Eigen::Vector2d current_sigma() const;
  double heading_error() const { return errors_(2); }
  /// m2/s2 of a velocity over ground that is measured now.
  Eigen::Matrix2d velocity_covariance(const Eigen::Vector2d& measured, SpeedOver over) const;

 private:
  using Row = Eigen::Matrix<double, 1, 6>;
  /// How the velocity over ground changes with each error.
  Eigen::Matrix<double, 2, 6> sensitivity(const Eigen::Vector2d& measured, SpeedOver over) const;
  void forget(double dt);
  double noise_mps(SpeedOver over) const;
  struct Compared {
    Row by_error;
    double innovation, variance;
  };
  navigation::Innovations update(std::array<Compared, 2> rows);
  void update(const Row& h, double innovation, double variance);

  ReckoningErrors sigmas_;
  Vector6 errors_ = Vector6::Zero();  ///< position: the step that is still to be taken
  Matrix6 covariance_;
};

}  // namespace drydock::pipeline
