// A gap in which nobody tells the heading: where may the vehicle have been?
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <random>

#include "estimators/smoothing/level_smoother.hpp"
#include "estimators/smoothing/noise_fit.hpp"

namespace drydock::smoothing {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double dvl_mps = 0.01, compass_rad = 0.01, step_s = 0.5;
constexpr frame::Position first_place{0.7, -1.2, 0};

struct Legs {
  double before_rad = 0, behind_rad = 0;
  double before_mps = 1.5, behind_mps = 1.5;
  double gap_s = 300;
  double hold_s = 1e9;  ///< in the gap a course is held for so long, then comes any other one
  bool depth = false;   ///< a depth sensor goes on in the gap
};

struct Sailed {
  Dive dive;
  Vector2d end;  ///< true north and east at the first reading behind the gap, m
  double end_s = 0;
};

/// 300 s each before and behind, swinging about the course; between them the vehicle turns as it
/// likes. Integrated in closed form, step by step.
Sailed sail(const Legs& legs, std::uint64_t seed) {
  constexpr double leg_s = 300;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> unit;
  std::uniform_real_distribution<double> any(-M_PI, M_PI);
  Sailed sailed;
  sailed.end_s = leg_s + legs.gap_s;
  Vector2d at = Vector2d::Zero();
  double heading = legs.before_rad, course = legs.before_rad, held_s = 0;
  for (double t = 0; t < sailed.end_s + leg_s; t += step_s) {
    const bool before = t < leg_s, behind = t >= sailed.end_s;
    if (!before && !behind && (held_s += step_s) >= legs.hold_s) {
      course = any(random);
      held_s = 0;
    }
    if (behind) course = legs.behind_rad;
    const double wanted = frame::wrap_pi(course + 0.05 * std::sin(2 * M_PI * t / 60) - heading);
    const double most = behind && t < sailed.end_s + step_s ? M_PI : 0.05;
    heading += std::clamp(wanted, -most, most);
    const double speed = t < leg_s + legs.gap_s / 2 ? legs.before_mps : legs.behind_mps;
    if (t == sailed.end_s) sailed.end = at;
    const bool is_epoch = std::fmod(t, 2) == 0;
    if (is_epoch && (before || behind)) {
      sailed.dive.readings.push_back({t,
                                      Quantity::bottom,
                                      0,
                                      {speed + dvl_mps * unit(random), 0, 0},
                                      Eigen::Vector3d::Constant(dvl_mps)});
      sailed.dive.readings.push_back({t,
                                      Quantity::heading,
                                      0,
                                      {heading + compass_rad * unit(random), 0, 0},
                                      Eigen::Vector3d::Constant(compass_rad)});
    }
    if (is_epoch && legs.depth)
      sailed.dive.readings.push_back(
          {t, Quantity::depth, 1, {0, 0, 0}, Eigen::Vector3d::Constant(0.1)});
    at += speed * step_s * Vector2d(std::cos(heading), std::sin(heading));
  }
  return sailed;
}

LevelOptions level_options(const Dive& dive) {
  LevelOptions options;
  options.start = level_start(dive, first_place);
  options.sigmas.position_m = 0.01;
  options.sigmas.current_mps = 0;
  options.motion.current_mps = 0;
  return options;
}

struct Place {
  Vector2d at;
  Matrix2d covariance;
};

/// The likeliest motion, as `track` finds it.
LevelMotion motion_of(const Sailed& sailed) {
  return fit_noise(sailed.dive, level_options(sailed.dive), {}).motion;
}

Place behind_the_gap(const Sailed& sailed, const LevelMotion& motion) {
  auto options = level_options(sailed.dive);
  options.motion = motion;
  const auto track = smooth_level(sailed.dive, options);
  for (const auto& point : track.smoothed)
    if (point.time_s == sailed.end_s)
      return {frame::ned_offset(first_place, point.position).head<2>(),
              point.position_covariance.topLeftCorner<2, 2>()};
  return {};
}

double nees(const Sailed& sailed, const LevelMotion& motion) {
  const Place place = behind_the_gap(sailed, motion);
  const Vector2d error = place.at - sailed.end;
  return error.dot(place.covariance.inverse() * error) / 2;
}

/// A vehicle that keeps its speed is no farther away than its way, whatever it turned.
TEST(Gap, AVehicleIsNoFartherThanItsSpeedTakesItAndNobodyKnowsItsCourse) {
  const double way_m = 1.5 * 300;
  for (const double turned_rad : {0.0, 1.0, 2.0, 2.6, 3.1, -2.0}) {
    const auto sailed = sail({.before_rad = 0.4, .behind_rad = 0.4 + turned_rad}, 1);
    const Place place = behind_the_gap(sailed, motion_of(sailed));
    const Place start{300 * 1.5 * Vector2d(std::cos(0.4), std::sin(0.4)), {}};
    EXPECT_LT((place.at - start.at).norm(), 1.1 * way_m) << turned_rad;
    EXPECT_GT(std::sqrt(place.covariance(0, 0)), 0.9 * way_m) << turned_rad;
    EXPECT_GT(std::sqrt(place.covariance(1, 1)), 0.9 * way_m) << turned_rad;
    EXPECT_LT(std::sqrt(place.covariance.trace()), 4 * way_m) << turned_rad;
  }
}

/// (R_before + R_behind) v T / 2: the line between the two velocities.
TEST(Gap, TheWayIsTheMeanOfTheVelocitiesBeforeAndBehind) {
  for (const bool depth : {false, true}) {
    const auto sailed = sail(
        {.before_rad = 0, .behind_rad = M_PI / 2, .before_mps = 1, .behind_mps = 1, .depth = depth},
        2);
    const Place place = behind_the_gap(sailed, motion_of(sailed));
    EXPECT_NEAR(place.at.x(), 300 + 150, 20) << depth;
    EXPECT_NEAR(place.at.y(), 150, 20) << depth;
  }
}

/// Legs with any two courses and speeds, and in the gap any course for each `hold_s`.
double mean_nees(double gap_s, double hold_s, bool depth) {
  constexpr int runs = 40;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-M_PI, M_PI);
  std::optional<LevelMotion> motion;
  double sum = 0;
  for (int run = 0; run < runs; ++run) {
    const auto sailed = sail({.before_rad = any(random),
                              .behind_rad = any(random),
                              .behind_mps = run % 2 == 0 ? 1.5 : 0.5,
                              .gap_s = gap_s,
                              .hold_s = hold_s,
                              .depth = depth},
                             static_cast<std::uint64_t>(run));
    if (!motion) motion = motion_of(sailed);
    sum += nees(sailed, *motion);
  }
  return sum / runs;
}

TEST(Gap, ItsErrorsAreNotLargerThanItsCovarianceSaysWhateverTheVehicleDid) {
  for (const double gap_s : {60.0, 700.0, 5000.0})
    for (const double hold_s : {2 * gap_s, gap_s / 3})
      for (const bool depth : {false, true}) {
        const double nees = mean_nees(gap_s, hold_s, depth);
        EXPECT_LT(nees, 1.1) << gap_s << ' ' << hold_s << ' ' << depth;
        EXPECT_GT(nees, 0.05) << gap_s << ' ' << hold_s << ' ' << depth;
      }
}

}  // namespace
}  // namespace drydock::smoothing
