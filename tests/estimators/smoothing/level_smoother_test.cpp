#include "estimators/smoothing/level_smoother.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <limits>
#include <random>

#include "estimators/smoothing/noise_fit.hpp"
#include "tests/estimators/smoothing/dive_of.hpp"

namespace drydock::smoothing {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using test::drawn;
using test::offset;
using test::options_of;
using test::Voyage;

struct Consistency {
  double nees = 0, filter_square = 0, smoother_square = 0;
  int points = 0;

  /// Adds the points between the fixes, one a minute.
  void add(const Track& track, const Voyage& voyage, const std::vector<Voyage::Place>& truth) {
    for (std::size_t k = 60; k < truth.size(); k += 60) {
      if (voyage.at_surface(track.smoothed[k].time_s)) continue;
      const Vector2d place{truth[k].north, truth[k].east};
      const Vector2d error = offset(track.smoothed[k].position) - place;
      const Matrix2d p = track.smoothed[k].position_covariance.topLeftCorner<2, 2>();
      nees += error.dot(p.inverse() * error) / 2;
      smoother_square += error.squaredNorm();
      filter_square += (offset(track.filtered[k].position) - place).squaredNorm();
      ++points;
    }
  }
};

/// The wandering of the vehicle is found on another dive than those that are judged.
LevelMotion motion_of(const Voyage& voyage, double current_sigma) {
  const auto dive = drawn(voyage, 99, current_sigma);
  return fit_noise(dive.dive, options_of(dive), {}).motion;
}

Consistency of_dives(int dives, double current_sigma) {
  const Voyage voyage(420);
  const LevelMotion motion = motion_of(voyage, current_sigma);
  Consistency all;
  for (int run = 0; run < dives; ++run) {
    const auto dive = drawn(voyage, 100 + static_cast<std::uint64_t>(run), current_sigma);
    auto options = options_of(dive);
    options.motion = motion;
    all.add(smooth_level(dive.dive, options), voyage, dive.truth);
  }
  return all;
}

TEST(LevelSmoother, ItsErrorsAreAsLargeAsItsCovarianceSaysOn250DivesWithBottomTrack) {
  const auto all = of_dives(250, 0);
  EXPECT_EQ(all.points, 250 * 8);
  EXPECT_NEAR(all.nees / all.points, 1, 0.1);
}

/// Each dive has a DVL with a scale error of its own, 1 % (1 sigma), and fixes only at its ends.
TEST(LevelSmoother, AScaleErrorOfTheDvlIsFoundBetweenTheFixesAndPromisesNoMoreThanItKeeps) {
  const Voyage voyage(420);
  const LevelMotion motion = motion_of(voyage, 0);
  constexpr double sigma = 0.01;
  constexpr int dives = 100;
  std::mt19937_64 random(7);
  std::normal_distribution<double> scale_error(0, sigma);
  Consistency all;
  double squares = 0;
  std::size_t refused = 0;
  for (int run = 0; run < dives; ++run) {
    auto dive = drawn(voyage, 300 + static_cast<std::uint64_t>(run));
    const double scale = scale_error(random);
    for (auto& reading : dive.dive.readings)
      if (reading.quantity == Quantity::bottom) reading.value *= 1 + scale;
    auto options = options_of(dive);
    options.motion = motion;
    options.sigmas.bottom_scale = sigma;
    const auto track = smooth_level(dive.dive, options);
    all.add(track, voyage, dive.truth);
    EXPECT_LT(track.bottom_scale_sigma, sigma / 2);
    squares += std::pow((track.bottom_scale - scale) / track.bottom_scale_sigma, 2);
    for (std::size_t i = 0; i < track.residuals.size(); ++i)
      refused += dive.dive.readings[i].quantity == Quantity::fix && !track.residuals[i][0].used;
  }
  EXPECT_NEAR(all.nees / all.points, 1, 0.15);
  EXPECT_NEAR(squares / dives, 1, 4 * std::sqrt(2. / dives));  // chi-square, four sigmas
  EXPECT_EQ(refused, 0U);
}

/// A speed and a scale that are both unknown multiply: only a way between fixes tells them apart.
TEST(LevelSmoother, WithoutFixesTheScaleStaysAsUncertainAsItWas) {
  auto dive = drawn(Voyage(420), 5);
  std::erase_if(dive.dive.readings, [](const Reading& r) { return r.quantity == Quantity::fix; });
  auto options = options_of(dive);
  options.sigmas.bottom_scale = 0.01;
  const auto track = smooth_level(dive.dive, options);
  EXPECT_EQ(track.bottom_scale, 0);
  EXPECT_EQ(track.bottom_scale_sigma, 0.01);
}

TEST(LevelSmoother, HalvesTheErrorOfTheFilterBetweenFixes) {
  for (const double current_sigma : {0.0, 0.3}) {
    const auto all = of_dives(20, current_sigma);
    EXPECT_LT(std::sqrt(all.smoother_square), 0.5 * std::sqrt(all.filter_square)) << current_sigma;
  }
}

TEST(LevelSmoother, WithALogInACurrentItsErrorsAreAtMostAQuarterAboveItsCovariance) {
  // A current and a heading that are both uncertain multiply, which a linear covariance leaves out:
  // 500 dives give 1.13.
  const auto all = of_dives(100, 0.3);
  EXPECT_NEAR(all.nees / all.points, 1, 0.25);
}

TEST(LevelSmoother, NoEpochIsLessCertainThanTheFilters) {
  const auto dive = drawn(Voyage(300), 1);
  const auto track = smooth_level(dive.dive, options_of(dive));
  double least = 1;
  for (std::size_t k = 0; k < track.smoothed.size(); ++k) {
    const Eigen::Matrix3d gained =
        track.filtered[k].position_covariance - track.smoothed[k].position_covariance;
    least = std::min(least, gained.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff());
  }
  EXPECT_GT(least, -1e-9);
}

TEST(LevelSmoother, ItsResidualsAreWhiteAndOfUnitVariance) {
  double squares = 0;
  int count = 0;
  const LevelMotion motion = motion_of(Voyage(600), 0);
  for (std::uint64_t run = 0; run < 5; ++run) {
    const auto dive = drawn(Voyage(600), 50 + run);
    auto options = options_of(dive);
    options.motion = motion;
    for (const auto& axes : level_residuals(dive.dive, options))
      for (const auto& residual : axes) {
        if (!residual.used) continue;
        squares += residual.normalised() * residual.normalised();
        ++count;
      }
  }
  EXPECT_GT(count, 5 * 720 * 5);
  EXPECT_NEAR(squares / count, 1, 0.12);
}

TEST(LevelSmoother, AWildFixIsRefusedAndTheTrackStays) {
  auto dive = drawn(Voyage(300), 2);
  const auto before = smooth_level(dive.dive, options_of(dive));
  for (auto& reading : dive.dive.readings)
    if (reading.quantity == Quantity::fix && reading.time_s == 30) reading.value.x() += 1e-3;
  const auto after = smooth_level(dive.dive, options_of(dive));
  const auto wild = std::ranges::find_if(dive.dive.readings, [](const Reading& r) {
    return r.quantity == Quantity::fix && r.time_s == 30;
  });
  const auto& residual =
      after.residuals[static_cast<std::size_t>(wild - dive.dive.readings.begin())];
  EXPECT_TRUE(residual[0].known);
  EXPECT_FALSE(residual[0].used);
  EXPECT_TRUE(residual[1].used);
  EXPECT_NEAR(residual[0].value, 6.36e3, 30);  // a milliradian of the meridian
  EXPECT_LT((offset(before.smoothed[30].position) - offset(after.smoothed[30].position)).norm(), 1);
}

TEST(LevelSmoother, ALatencyOfTheModelMovesTheReadingsBack) {
  auto dive = drawn(Voyage(120), 3);
  const auto before = smooth_level(dive.dive, options_of(dive));
  for (auto& reading : dive.dive.readings)
    if (reading.quantity == Quantity::bottom) reading.time_s += 0.25;
  auto options = options_of(dive);
  options.sensors.resize(1);
  options.sensors[0].latency_s = 0.25;
  const auto after = smooth_level(dive.dive, options);
  ASSERT_EQ(after.smoothed.size(), before.smoothed.size());
  for (std::size_t k = 0; k < before.smoothed.size(); ++k)
    EXPECT_LT((offset(before.smoothed[k].position) - offset(after.smoothed[k].position)).norm(),
              1e-6);
}

TEST(LevelSmoother, AnAxisThatWasNotMeasuredIsPassedOver) {
  auto dive = drawn(Voyage(60), 4);
  for (auto& reading : dive.dive.readings)
    if (reading.quantity == Quantity::bottom)
      reading.value.z() = std::numeric_limits<double>::quiet_NaN();
  const auto track = smooth_level(dive.dive, options_of(dive));
  EXPECT_FALSE(track.residuals[0][2].known);
  EXPECT_TRUE(track.residuals[0][0].known);
  EXPECT_TRUE(track.smoothed.back().position_covariance.allFinite());
}

TEST(LevelSmoother, ADiveWithoutReadingsGivesNoTrack) {
  EXPECT_TRUE(smooth_level({}, {}).smoothed.empty());
}

TEST(NoiseFit, FindsTheNoiseThatASensorDoesNotState) {
  // DVL 1 cm/s instead of 5, depth 0.1 m instead of 1 m. The jerks of the vehicle look like noise
  // of its DVL, which is found a fifth too large at most.
  auto dive = drawn(Voyage(600), 7);
  scale_noise(dive.dive, {Quantity::bottom, 0}, 5);
  scale_noise(dive.dive, {Quantity::depth, 2}, 10);
  const auto fit =
      fit_noise(dive.dive, options_of(dive), {{Quantity::bottom, 0}, {Quantity::depth, 2}});
  EXPECT_NEAR(fit.factors.at(0), 0.2, 0.04);
  EXPECT_NEAR(fit.factors.at(1), 0.1, 0.01);
}

TEST(Tilts, AreOnALineBetweenTheirNeighboursAndStayBeyondTheEnds) {
  const std::vector<Tilt> tilts{{1, 0.1, 0.2}, {3, 0.3, -0.2}};
  EXPECT_DOUBLE_EQ(tilt_at(tilts, 2).roll_rad, 0.2);
  EXPECT_DOUBLE_EQ(tilt_at(tilts, 2).pitch_rad, 0);
  EXPECT_DOUBLE_EQ(tilt_at(tilts, 0).roll_rad, 0.1);
  EXPECT_DOUBLE_EQ(tilt_at(tilts, 9).pitch_rad, -0.2);
  EXPECT_DOUBLE_EQ(tilt_at({}, 9).pitch_rad, 0);
}

}  // namespace
}  // namespace drydock::smoothing
