#include "estimators/pipeline/rate_leap.hpp"

#include <gtest/gtest.h>

#include <random>

namespace drydock::pipeline::rate_leap_test {
namespace {

constexpr double noise = 2e-3;  // rad/s

TEST(RateLeap, IsTheChangeSixteenSamplesAfterIt) {
  RateLeap leap;
  for (int i = 0; i < 50; ++i) ASSERT_EQ(leap.add(1, 1e-6), 0);
  for (int i = 1; i < 16; ++i) ASSERT_EQ(leap.add(1.5, 1), 0);  // so much noise hides it
  EXPECT_NEAR(leap.add(1.5, 1e-6), 0.5, 1e-12);
}

TEST(RateLeap, OfABodyThatSpinsUpEvenlyIsNone) {
  RateLeap leap;
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(leap.add(0.2 * i, 1e-6), 0);
}

TEST(RateLeap, OfNoiseIsNoneAndHasTheSigmaOfItsClosedForm) {
  // Means of eight have noise / root 8; two count 1.5 times, two .5 times: root of 5/8 of a sample.
  // Six sigmas are exceeded twice in 1e9 samples, 3.09 once in 500: in about 2000 of a million, of
  // which those in a row are one.
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0, noise);
  RateLeap sound, eager;
  int leaps = 0, taken_for_leaps = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const double rate = normal(random);
    leaps += sound.add(rate, noise) != 0;
    taken_for_leaps += eager.add(rate, noise * 3.09 / RateLeap::limit) != 0;
  }
  EXPECT_EQ(leaps, 0);
  EXPECT_GT(taken_for_leaps, 300);
  EXPECT_LT(taken_for_leaps, 2000);
}

TEST(RateLeap, OfSevenSigmasIsFoundWhereverTheNoisePutsIt) {
  // 7 sigmas of a sample are 8.85 of the statistic: 1 in 400 is below 6, and as few look bent.
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, noise);
  int found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    RateLeap leap;
    for (int i = 0; i < 100; ++i)
      found += leap.add(normal(random) + (i < 60 ? 0 : 7 * noise), noise) > 0;
  }
  EXPECT_GE(found, 198);
  EXPECT_LE(found, 200);
}

}  // namespace
}  // namespace drydock::pipeline::rate_leap_test
