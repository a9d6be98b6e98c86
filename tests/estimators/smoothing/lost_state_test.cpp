// What the level model does where its state is lost: over a long gap, and where it refuses all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimators/smoothing/level_smoother.hpp"

namespace drydock::smoothing {
namespace {

constexpr double speed_mps = 1.5, sigma_mps = 0.01, sigma_rad = 0.01;
constexpr frame::Position begin{0.7, -1.2, 0};

void sense(Dive& dive, double time_s, double heading_rad) {
  dive.readings.push_back(
      {time_s, Quantity::bottom, 0, {speed_mps, 0, 0}, Eigen::Vector3d::Constant(sigma_mps)});
  dive.readings.push_back(
      {time_s, Quantity::heading, 0, {heading_rad, 0, 0}, Eigen::Vector3d::Constant(sigma_rad)});
}

LevelOptions options_of(const Dive& dive) {
  LevelOptions options;
  options.start = level_start(dive, begin);
  options.sigmas.position_m = 0.01;
  options.sigmas.current_mps = 0;
  return options;
}

std::ptrdiff_t refused_headings(const Dive& dive, const Residuals& residuals) {
  std::ptrdiff_t refused = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i)
    refused += dive.readings[i].quantity == Quantity::heading && !residuals[i][0].used ? 1 : 0;
  return refused;
}

/// The AUV of docs/estimators/dead-reckoning.md: readings every 2 s, then none for 4722 s. Where a
/// vehicle of this speed may then be is bounded by its way, and by what its speed wanders in a line
/// (q T^1.5 / sqrt(3)): 13 km to any side, and 19 km.
TEST(LostState, OverALongGapTheVehicleIsNoFartherThanItsSpeedTakesIt) {
  constexpr double gap_s = 4722;
  Dive dive;
  for (int k = 0; k < 60; ++k) sense(dive, 2 * k, 0.01 * k);
  for (int k = 0; k < 60; ++k) sense(dive, 118 + gap_s + 2 * k, 2 + 0.01 * k);
  const auto options = options_of(dive);
  const auto track = smooth_level(dive, options);
  const auto& last = track.filtered.back().position_covariance;
  const double wander_m = options.motion.velocity_mps * std::pow(gap_s, 1.5) / std::numbers::sqrt3;
  const double any_way_m = std::numbers::pi / std::numbers::sqrt3 * speed_mps * gap_s;
  EXPECT_LT(std::sqrt(last.topLeftCorner<2, 2>().trace()),
            std::sqrt(2) * std::hypot(wander_m, any_way_m) + speed_mps * gap_s);
  EXPECT_GT(std::sqrt(last(0, 0)), speed_mps * gap_s / 2);
  EXPECT_EQ(refused_headings(dive, track.residuals), 0);
}

TEST(LostState, AVehicleThatWasTurnedByHandIsFollowedAfterThreeReadings) {
  Dive dive;
  for (int k = 0; k < 200; ++k) sense(dive, k, k < 100 ? 0.2 : 2.7);
  auto options = options_of(dive);
  options.motion.turn_radps = 1e-3;  // it hardly turns by itself
  const auto track = smooth_level(dive, options);
  EXPECT_EQ(refused_headings(dive, track.residuals), 3);
  EXPECT_NEAR(track.smoothed.back().attitude.yaw, 2.7, 0.02);
}

}  // namespace
}  // namespace drydock::smoothing
