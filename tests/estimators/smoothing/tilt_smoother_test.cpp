#include "estimators/smoothing/tilt_smoother.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "estimators/smoothing/level_smoother.hpp"

namespace drydock::smoothing {
namespace {

constexpr double degree = M_PI / 180;

/// A pitch with its rate at a time.
struct Pitch {
  double angle, rate;
};

/// A swell of 3 degrees and 8 s.
Pitch swell(double t) {
  const double w = 2 * M_PI / 8, a = 3 * degree;
  return {a * std::sin(w * t), a * w * std::cos(w * t)};
}

/// Level, and every five minutes 15 degrees down and up again over 30 s.
Pitch dives(double t) {
  const double u = std::fmod(t, 300), w = 2 * M_PI / 30, a = 7.5 * degree;
  return u < 30 ? Pitch{a * (std::cos(w * u) - 1), -a * w * std::sin(w * u)} : Pitch{0, 0};
}

std::vector<Tilt> measured(Pitch (*pitch)(double), double period_s, int count, double noise_rad) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> unit;
  std::vector<Tilt> tilts;
  for (int i = 0; i < count; ++i) {
    const double t = i * period_s;
    tilts.push_back({t, noise_rad * unit(random), pitch(t).angle + noise_rad * unit(random)});
  }
  return tilts;
}

struct Errors {
  double angle = 0, rate = 0;  ///< RMS
};

Errors errors(const std::vector<Tilt>& tilts, Pitch (*pitch)(double), double offset_s) {
  Errors sum;
  for (const Tilt& tilt : tilts) {
    const Tilt at = tilt_at(tilts, tilt.time_s + offset_s);
    sum.angle += std::pow(at.pitch_rad - pitch(at.time_s).angle, 2);
    sum.rate += std::pow(at.pitch_radps - pitch(at.time_s).rate, 2);
  }
  const auto count = static_cast<double>(tilts.size());
  return {std::sqrt(sum.angle / count), std::sqrt(sum.rate / count)};
}

TEST(TiltSmoother, HalvesTheNoiseOfASwellAndFindsItsRate) {
  const auto found = errors(smooth_tilts(measured(swell, 0.1, 3000, 0.1 * degree)), swell, 0.03);
  EXPECT_LT(found.angle, 0.05 * degree);
  EXPECT_LT(found.rate, 0.15 * degree);  // per s; two neighbours alone would give 1.4
}

TEST(TiltSmoother, IsAsGoodBetweenTheTiltsAsAtThem) {
  // On a line between two measured ones the noise would be .071 degrees in the middle, .1 at them.
  const auto tilts = smooth_tilts(measured(dives, 2, 900, 0.1 * degree));
  const auto at = errors(tilts, dives, 0), between = errors(tilts, dives, 1);
  EXPECT_LT(at.angle, 0.065 * degree);
  EXPECT_NEAR(between.angle / at.angle, 1, 0.1);
}

TEST(TiltSmoother, LeavesTiltsWithoutNoiseAsTheyAre) {
  const auto exact = measured(swell, 0.1, 1000, 0);
  const auto tilts = smooth_tilts(exact);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(tilts[i].pitch_rad, exact[i].pitch_rad, 1e-3 * degree) << i;
    EXPECT_EQ(tilts[i].roll_rad, 0) << i;
  }
}

TEST(TiltSmoother, AGapIsALine) {
  auto tilts = measured(swell, 0.1, 1000, 0.1 * degree);
  for (std::size_t i = 500; i < tilts.size(); ++i) tilts[i].time_s += 3600;
  const auto middle = tilt_at(smooth_tilts(tilts), 1850);
  EXPECT_LT(std::abs(middle.pitch_rad), 3.2 * degree);
  EXPECT_LT(std::abs(middle.pitch_radps), 1e-4);
}

TEST(TiltSmoother, OfAFewTiltsThereIsNothingToSmooth) {
  EXPECT_TRUE(smooth_tilts({}).empty());
  const auto one = smooth_tilts({{1, 0.1, 0.2}});
  EXPECT_EQ(one.front().pitch_rad, 0.2);
  EXPECT_EQ(one.front().pitch_radps, 0);
}

/// Rigid body: the place l moves with omega x l. Here omega is the rate of pitch, about y.
TEST(LevelSmoother, ADvlAheadOfTheOriginFeelsTheRateOfPitch) {
  const Eigen::Vector3d lever{0.8, 0.1, 0.35};
  Dive dive;
  for (int i = 0; i < 200; ++i) {
    const double t = i * 0.2;
    const auto [pitch, rate] = swell(t);
    dive.tilts.push_back({t, 0, pitch, 0, rate});
    const Eigen::Vector3d body{1.5 * std::cos(pitch) + rate * lever.z(), 0,
                               1.5 * std::sin(pitch) - rate * lever.x()};
    dive.readings.push_back({t, Quantity::bottom, 0, body, Eigen::Vector3d::Constant(0.01)});
  }
  LevelOptions options;
  options.start.velocity.x() = 1.5;
  options.sensors.resize(1);
  options.sensors[0].lever = lever;
  for (const auto& axes : level_residuals(dive, options))
    for (const auto& axis : axes) EXPECT_NEAR(axis.value, 0, 1e-9);
}

}  // namespace
}  // namespace drydock::smoothing
