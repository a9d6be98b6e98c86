#pragma once

#include <random>

#include "estimators/smoothing/level_smoother.hpp"

/// A dive in closed form with the readings of sensors whose errors are drawn: an independent check
/// of the smoother, which shares only the Earth of estimators/frame with it.
namespace drydock::smoothing::test {

/// A minute at the surface with fixes, `under_s` without, and a minute with fixes again. The
/// vehicle swings about its course, with a speed that breathes, and dives to 40 m and back.
class Voyage {
 public:
  explicit Voyage(double under_s) : under_s_(under_s) {}

  struct Place {
    double north = 0, east = 0, depth = 0;
    double heading = 0, pitch = 0, turn = 0;
    Eigen::Vector3d velocity_level = Eigen::Vector3d::Zero();
  };
  std::vector<Place> each_second(std::uint64_t seed) const;  ///< integrated over steps of 50 ms
  double duration_s() const { return under_s_ + 120; }
  bool at_surface(double t) const { return t < 60 || t > duration_s() - 60; }

 private:
  double under_s_;
};

struct Drawn {
  Dive dive;
  std::vector<Voyage::Place> truth;  ///< each second
};

inline constexpr frame::Position origin{0.63, 2.25, 0};

/// Noise: DVL 1 cm/s, heading .5 degree with a bias of 1 degree (1 sigma), depth .1 m, fixes 1.5 m.
/// `current`: of the water, m/s north and east, 1 sigma; a log then speaks in the place of the DVL.
Drawn drawn(const Voyage& voyage, std::uint64_t seed, double current_sigma = 0);

/// What is known of such a dive before it.
LevelOptions options_of(const Drawn& drawn);

/// m north and east of the origin.
Eigen::Vector2d offset(const frame::Position& position);

}  // namespace drydock::smoothing::test
