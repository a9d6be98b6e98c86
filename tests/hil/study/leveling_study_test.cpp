#include "hil/study/leveling/leveling_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "estimators/frame/earth.hpp"
#include "hil/study/leveling/leveling_covariance.hpp"

/// The paper's chapter 4 with fewer runs than the study, but the same claims. The full numbers are
/// in docs/estimators/leveling.md with the command that prints them.
namespace drydock::study {
namespace {

using leveling::FilterKind;
using leveling::LevelingOptions;
using leveling::options_for;
using namespace leveling_motions;

struct Silent final : Progress {
  void on_run(std::string_view, std::size_t, std::size_t) override {}
  bool stopped() const override { return false; }
};

LevelingStatistics over_runs(std::size_t runs, LevelingTrial trial, FilterKind kind,
                             const LevelingOptions& options) {
  LevelingStatistics statistics;
  for (trial.run = 0; trial.run < runs; ++trial.run)
    statistics.add(run_leveling(trial, leveling_readings(trial), kind, options));
  return statistics;
}

LevelingStatistics over_runs(std::size_t runs, const LevelingTrial& trial, FilterKind kind) {
  return over_runs(runs, trial, kind, options_for(kind));
}

constexpr double floor_deg = 0.0573;  // 1 mg of accelerometer bias divided by gravity

TEST(LevelingStudy, RobustIsNeverUpsideDownAndBetterThanThePaperOnTheMove) {
  const auto s = over_runs(40, {s_path}, FilterKind::robust);
  EXPECT_EQ(s.diverged, 0U);
  EXPECT_LE(std::abs(s.at_the_end().roll_mean), 0.083);
  EXPECT_LE(std::abs(s.at_the_end().pitch_mean), 0.058);
  EXPECT_LE(s.at_the_end().roll_std, 0.010);
  EXPECT_LE(s.at_the_end().pitch_std, 0.005);
}

TEST(LevelingStudy, RollPitchAndSideslipDoNotTurnItOver) {
  for (const auto kind : {FilterKind::robust, FilterKind::augmented}) {
    const auto s = over_runs(40, {rolling_s_path}, kind);
    EXPECT_EQ(s.diverged, 0U);
    EXPECT_LE(s.roll_rms(), 0.06);
    EXPECT_LE(s.pitch_rms(), 0.07);
  }
}

TEST(LevelingStudy, AtRestTheErrorIsTheAccelerometerBiasOverGravity) {
  for (const auto& filter : leveling_filters) {
    const auto end = over_runs(20, {stationary, true}, filter.kind).at_the_end();
    EXPECT_NEAR(end.roll_mean, -floor_deg, 0.007) << filter.name;
    EXPECT_NEAR(end.pitch_mean, +floor_deg, 0.007) << filter.name;
    EXPECT_LT(end.roll_std, 0.001) << filter.name;
    EXPECT_LT(end.pitch_std, 0.001) << filter.name;
  }
}

TEST(LevelingStudy, ThePapersFilterLosesTheRunsThatBeginUpsideDown) {
  // alpha_3 < 0 if exactly one of two N(0, 45^2) angles is beyond 90 degrees, two sigma: 8.7 %.
  const double beyond = std::erfc(2 / std::sqrt(2.0)), share = 2 * beyond * (1 - beyond);
  constexpr double runs = 150;
  const auto lost = over_runs(150, {s_path}, FilterKind::paper).diverged;
  EXPECT_NEAR(static_cast<double>(lost), runs * share, 3 * std::sqrt(runs * share * (1 - share)));
}

TEST(LevelingStudy, TheVerticalConstraintAloneCuresThat) {
  auto options = options_for(FilterKind::robust);
  options.accelerometer_start = false;
  options.transverse_speed_density.reset();
  EXPECT_EQ(over_runs(60, {s_path}, FilterKind::robust, options).diverged, 0U);
}

TEST(LevelingStudy, AnAccelerometerStartAloneCuresThat) {
  auto options = options_for(FilterKind::paper);
  options.accelerometer_start = true;
  const auto s = over_runs(40, {s_path}, FilterKind::paper, options);
  EXPECT_EQ(s.diverged, 0U);
  EXPECT_LE(s.at_the_end().roll_std, 0.010);
}

TEST(LevelingStudy, OnAStraightCourseOnlyTheTransverseConstraintHoldsRoll) {
  const LevelingTrial trial{straight};
  const auto held = over_runs(20, trial, FilterKind::robust).at_the_end();
  EXPECT_NEAR(held.roll_mean, -floor_deg, 0.007);
  EXPECT_LE(held.roll_std, 0.002);
  auto options = options_for(FilterKind::robust);
  options.transverse_speed_density.reset();
  EXPECT_GT(over_runs(10, trial, FilterKind::robust, options).at_the_end().roll_std, 0.1);
  EXPECT_GT(over_runs(10, trial, FilterKind::paper).diverged, 5U);  // Fig. 4 (a)
}

TEST(LevelingStudy, AugmentedGoesBelowTheFloorOfTheBiases) {
  for (const auto biases : leveling_biases) {
    const auto s = over_runs(60, {s_path, false, biases}, FilterKind::augmented);
    EXPECT_LE(s.roll_rms(), 0.015);
    EXPECT_LE(s.pitch_rms(), 0.025);
    EXPECT_LT(s.settled_p95_s(), 10);
    EXPECT_EQ(s.diverged, 0U);
  }
}

TEST(LevelingStudy, AugmentedKnowsItsErrorInEveryMotion) {
  // chi-squared of 2 x 60 degrees of freedom, 99.9 %: 0.64 to 1.46 per state.
  for (const auto& which : leveling_cases) {
    const auto s = over_runs(60, {which.motion, which.stationary, LevelingBiases::drawn},
                             FilterKind::augmented);
    EXPECT_GT(s.nees_mean(), 0.64) << which.name;
    EXPECT_LT(s.nees_mean(), 1.46) << which.name;
  }
}

TEST(LevelingStudy, SixStatesDoNotKnowTheirErrorOnceThereAreBiases) {
  EXPECT_GT(over_runs(20, {s_path, false, LevelingBiases::drawn}, FilterKind::robust).nees_mean(),
            5);
  EXPECT_LT(over_runs(40, {s_path, false, LevelingBiases::none}, FilterKind::robust).nees_mean(),
            1.2);
}

TEST(LevelingCovariance, AtRestATiltIsTheSlopeOfTheVelocity) {
  // V = g alpha t + V0 is measured n times with sigma, on a random walk of q per sqrt(s). The
  // variance of the slope is 12 sigma^2 / (n T^2) + 6/5 q^2 / T.
  const auto analysis = analyse_leveling(stationary, true);
  const double t = 1, n = 100, sigma = 0.01, q = 1e-3, g = frame::gravity(leveling_latitude_rad);
  const double slope = 12 * sigma * sigma / (n * t * t) + 1.2 * q * q / t;
  const double expected = slope / (g * g);
  EXPECT_NEAR(analysis.variance[0][100], expected, 0.01 * expected);
  EXPECT_NEAR(analysis.variance[1][100], expected, 0.01 * expected);
  EXPECT_EQ(analysis.variance[2][0], 1);  // the paper's P0
}

TEST(LevelingCovariance, IsOrderedAsThePaperSays) {
  const auto at_rest = analyse_leveling(stationary, true);
  const auto on_a_line = analyse_leveling(straight, false);
  const auto turning = analyse_leveling(s_path, false);
  const std::size_t end = at_rest.t_s.size() - 1, second = 100;
  EXPECT_EQ(at_rest.t_s[end], 30);
  // "The covariance decreases very fast" at rest. While moving, roll can be observed only in turns.
  EXPECT_LT(at_rest.variance[1][second], 1e-4 * on_a_line.variance[1][second]);
  EXPECT_LT(turning.variance[1][end], 1e-3 * on_a_line.variance[1][end]);
  EXPECT_GT(on_a_line.variance[1][end], 0.002);  // 2.6 degrees
}

TEST(LevelingStudy, IsTheSameToTheLastBitWithAnyNumberOfJobs) {
  Silent silent;
  const auto alone = leveling_study({3, 9, 1}, silent),
             together = leveling_study({3, 9, 3}, silent);
  EXPECT_EQ(alone.json.dump(), together.json.dump());
  ASSERT_EQ(alone.figures.size(), together.figures.size());
  for (std::size_t i = 0; i < alone.figures.size(); ++i)
    for (std::size_t k = 0; k < alone.figures[i].curves.size(); ++k)
      EXPECT_EQ(alone.figures[i].curves[k].y, together.figures[i].curves[k].y);
  EXPECT_NE(alone.json.dump(), leveling_study({3, 10, 1}, silent).json.dump());
}

TEST(LevelingStudy, ItsJsonHasEveryFilterInEveryMotion) {
  Silent silent;
  const auto result = leveling_study({2, 1, 2}, silent);
  for (const auto* table : {&result.json, &result.json["drawn_biases"]})
    for (const char* filter : {"paper", "robust", "augmented"})
      for (const char* motion : {"stationary", "moving_s", "straight"})
        for (const char* key : {"roll_mean_deg", "pitch_mean_deg", "roll_std_deg", "pitch_std_deg",
                                "roll_rms_deg", "pitch_rms_deg", "diverged_runs", "nees_mean"})
          EXPECT_TRUE(table->at(filter).at(motion).at(key).is_number()) << filter << motion << key;
  EXPECT_EQ(result.json["published"]["moving_s"]["roll_mean_deg"], 0.083);
  for (const auto& table : result.tables)
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  const std::string titles = [&] {
    std::string all;
    for (const auto& figure : result.figures) all += figure.title + "\n";
    return all;
  }();
  for (const char* figure : {"Fig. 3", "Fig. 4 (a)", "Fig. 4 (b)", "Fig. 5 (a)", "Fig. 5 (b)",
                             "Fig. 6", "Fig. 7", "Fig. 8", "Fig. 9"})
    EXPECT_THAT(titles, testing::HasSubstr(figure));
}

}  // namespace
}  // namespace drydock::study
