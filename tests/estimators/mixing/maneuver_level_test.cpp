#include "estimators/mixing/maneuver_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

/// Compares the fuzzy inference with Table 3 of the paper and with a simple implementation.
namespace drydock::mixing::maneuver_level_test {
namespace {

// Table 3 as printed: rows 0 to 0.05 rad/s, columns 0 to 5 m/s2.
constexpr int table_3[6][6] = {{1, 5, 7, 8, 9, 10},      {3, 5, 7, 8, 8, 10},
                               {8, 8, 10, 10, 10, 10},   {12, 11, 12, 11, 11, 12},
                               {12, 11, 12, 11, 11, 12}, {12, 11, 12, 11, 11, 12}};

enum { VS, S, M, B, VB };
// Table 1 as printed: rows input 1 (attitude rate), columns input 2 (velocity rate).
constexpr int table_1[5][5] = {
    {VS, VS, S, M, B}, {S, S, S, M, B}, {M, M, M, B, B}, {B, B, B, B, B}, {VB, VB, VB, VB, VB}};

/// A triangle that ends at the peaks of its neighbours. The first and the last set have a shoulder.
double membership(const Peaks& peaks, int set, double x) {
  const auto i = static_cast<std::size_t>(set);
  if (x == peaks[i] || (set == VS && x < peaks[0]) || (set == VB && x > peaks[4])) return 1;
  if (x < peaks[i]) return std::max(0.0, (x - peaks[i - 1]) / (peaks[i] - peaks[i - 1]));
  return set == VB ? 1 : std::max(0.0, (peaks[i + 1] - x) / (peaks[i + 1] - peaks[i]));
}

/// All 25 rules, then all five sets at all 61 points.
int plain_level(double rate, double acceleration, const FuzzySets& sets) {
  const Peaks output{-30, -15, 0, 15, 30};
  double concluded[5] = {};
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      const double fires = std::min(membership(sets.attitude_rate, i, rate),
                                    membership(sets.velocity_rate, j, acceleration));
      double& conclusion = concluded[table_1[i][j]];
      conclusion = std::max(conclusion, fires);
    }
  }
  double area = 0, moment = 0;
  for (int y = -30; y <= 30; ++y) {
    double value = 0;
    for (int set = 0; set < 5; ++set) {
      value = std::max(value, std::min(concluded[set], membership(output, set, y)));
    }
    area += value;
    moment += value * y;
  }
  return static_cast<int>(std::floor((moment / area + 30) / 5 + 1e-9)) + 1;  // eq. (9)
}

int cells_matched(const FuzzySets& sets) {
  int matched = 0;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) matched += inferred_level(0.01 * i, j, sets) == table_3[i][j];
  }
  return matched;
}

TEST(ManeuverLevel, InferenceGivesAll36CellsOfTable3) {
  EXPECT_EQ(cells_matched(FuzzySets{}), 36);
  EXPECT_EQ(cells_matched(pointed_sets), 36);
}

TEST(ManeuverLevel, EquallySpacedSetsWouldNot) {
  EXPECT_LT(cells_matched({{0, 0.0125, 0.025, 0.0375, 0.05}, {0, 1.25, 2.5, 3.75, 5}}), 12);
}

TEST(ManeuverLevel, LeanInferenceIsThePlainOneOnRandomInputs) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> rate(0, 0.06), acceleration(0, 6);
  for (int i = 0; i < 100'000; ++i) {
    const double a = rate(random), b = acceleration(random);
    const FuzzySets& sets = i % 2 == 0 ? pointed_sets : FuzzySets{};
    ASSERT_EQ(inferred_level(a, b, sets), plain_level(a, b, sets)) << a << " " << b;
  }
}

TEST(ManeuverLevel, CentresOfAreaOfSingleSetsAreThoseOfTheirPoints) {
  const FuzzySets sets;
  // VS alone: weights 15, 14, ... 1 at -30, -29, ... -16: mean -30 + 14/3.
  EXPECT_NEAR(inferred_maneuver(0, 0, sets), -30 + 14.0 / 3, 1e-12);
  EXPECT_EQ(inferred_maneuver(0.0175, 0, sets), 0);  // M alone is exactly symmetrical
  EXPECT_NEAR(inferred_maneuver(0.0225, 0, sets), 15, 1e-12);
  EXPECT_NEAR(inferred_maneuver(1, 100, sets), 30 - 14.0 / 3, 1e-12);
}

TEST(ManeuverLevel, SmallInputsStayAtLevelOneOnThePlateauAlone) {
  EXPECT_EQ(inferred_level(0.0029, 0.14, FuzzySets{}), 1);
  EXPECT_GT(inferred_level(0.0029, 0, pointed_sets), 1);
}

TEST(ManeuverLevel, ScheduleIsTable3AtTheNearestBoundary) {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      EXPECT_EQ(level_table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)],
                table_3[i][j]);
      for (const double off : {-0.49, 0.0, 0.49}) {
        EXPECT_EQ(scheduled_level(std::max(0.0, 0.01 * (i + off)), std::max(0.0, j - off)),
                  table_3[i][j]);
      }
    }
  }
  EXPECT_EQ(scheduled_level(1e6, 1e6), 12);
}

TEST(ManeuverLevel, GainsAreThoseOfTable2) {
  EXPECT_EQ(gains_of_level(1).k1, 0.1);
  EXPECT_EQ(gains_of_level(4).k1, 0.005);
  EXPECT_EQ(gains_of_level(12).k1, 0.0000005);
  for (int level = 1; level <= 12; ++level) {
    EXPECT_NEAR(gains_of_level(level).k2 / gains_of_level(level).k1, 0.1, 1e-12);
    if (level > 1) {
      EXPECT_LT(gains_of_level(level).k1, gains_of_level(level - 1).k1);
    }
  }
}

}  // namespace
}  // namespace drydock::mixing::maneuver_level_test
