#include "estimators/consistency/cusum.hpp"

#include <gtest/gtest.h>

#include <random>

namespace drydock::consistency {
namespace {

/// The mean number of Gaussian samples with this mean until the limit, over many runs.
double simulated(const CusumDesign& design, double shift, int runs) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(shift, 1);
  double total = 0;
  for (int run = 0; run < runs; ++run) {
    Cusum cusum;
    for (; cusum.value() < design.limit; ++total) cusum.take(noise(random), design);
  }
  return total / runs;
}

// Lucas and Crosier 1982: two sides, k = 0.5, h = 4 and 5.
TEST(Cusum, HasTheMeanTimesToAnAlarmOfThePublishedTables) {
  EXPECT_NEAR(mean_samples_to_alarm({0.5, 4}), 168, 0.03 * 168);
  EXPECT_NEAR(mean_samples_to_alarm({0.5, 5}), 465, 0.03 * 465);
  EXPECT_NEAR(mean_samples_to_alarm({0.5, 4}, 1), 8.38, 0.03 * 8.38);
  EXPECT_NEAR(mean_samples_to_alarm({0.5, 5}, 1), 10.4, 0.03 * 10.4);
}

TEST(Cusum, GivesFalseAlarmsAsRarelyAsSiegmundsFormulaSays) {
  EXPECT_NEAR(simulated({0.5, 4}, 0, 4000) / 168, 1, 0.06);
  EXPECT_NEAR(simulated({1, 3}, 0, 1000) / mean_samples_to_alarm({1, 3}), 1, 0.15);
}

// Lorden 1971: a shift of d sigmas takes about h / (d - k) samples.
TEST(Cusum, FindsAShiftAsFastAsLordensBoundSays) {
  const CusumDesign design{};
  EXPECT_NEAR(simulated(design, 2, 4000), mean_samples_to_alarm(design, 2), 0.5);
  EXPECT_NEAR(simulated(design, 3, 4000), (design.limit + 1) / (3 - design.reference), 0.7);
}

// A day of 100 tests with 5 samples a second is 4.32e7 samples.
TEST(Cusum, OfTheRoomsDesignGivesAHundredTestsOneFalseAlarmInFourYears) {
  EXPECT_GT(mean_samples_to_alarm(CusumDesign{}), 4 * 365.25 * 4.32e7);
}

TEST(Cusum, OneWildResidualAloneNeverFires) {
  Cusum cusum;
  cusum.take(1e9, {});
  EXPECT_LT(cusum.value(), CusumDesign{}.limit);
  for (int i = 0; i < 4; ++i) cusum.take(0, {});
  EXPECT_EQ(cusum.value(), 0);
}

TEST(Cusum, ForgetsALongFaultWithinFifteenSamples) {
  Cusum cusum;
  for (int i = 0; i < 1000; ++i) cusum.take(-8, {});
  for (int i = 0; i < 15; ++i) cusum.take(0, {});
  EXPECT_EQ(cusum.value(), 0);
}

}  // namespace
}  // namespace drydock::consistency
