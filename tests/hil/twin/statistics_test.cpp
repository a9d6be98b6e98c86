#include "hil/twin/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace drydock::twin {
namespace {

std::vector<Error> at_times(const std::vector<double>& times_s) {
  std::vector<Error> errors;
  for (const double t : times_s)
    errors.push_back({.valid_at = measurement::Stamp{} + measurement::from_seconds(t)});
  return errors;
}

TEST(Timing, CountsTheSamplesThatAreMissing) {
  const auto timing = timing_of(at_times({0, 0.5, 1, 3, 3.5, 4, 4.5, 5.5, 6}));
  EXPECT_EQ(timing.samples, 9u);
  EXPECT_NEAR(timing.rate_hz, 2, 1e-9);
  EXPECT_EQ(timing.outages, 2u);
  EXPECT_EQ(timing.lost, 4u);  // 1.5, 2, 2.5 and 5
  EXPECT_NEAR(timing.longest_gap_s, 2, 1e-9);
}

TEST(Timing, OfNoneAndOfOneSampleHasNoRate) {
  EXPECT_EQ(timing_of({}).rate_hz, 0);
  EXPECT_EQ(timing_of(at_times({1})).rate_hz, 0);
  EXPECT_EQ(timing_of(at_times({1, 1, 1})).rate_hz, 0);
}

/// White noise of deviation `white` and a Gauss-Markov process of `slow` and tau_s, each 0.1 s.
std::vector<double> noise(double white, double slow, double tau_s, std::size_t count) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const double keep = std::exp(-0.1 / tau_s);
  double state = slow * normal(random);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(3 + state + white * normal(random));
    state = keep * state + slow * std::sqrt(1 - keep * keep) * normal(random);
  }
  return values;
}

TEST(Noise, OfWhiteNoiseIsWhite) {
  const auto found = noise_of(noise(0.2, 0, 1, 20'000), 0.1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mean, 3, 4 * 0.2 / std::sqrt(20'000));
  EXPECT_NEAR(found->white, 0.2, 0.004);  // 1/sqrt(2n) is 0.5 %
  EXPECT_EQ(found->slow, 0);
}

TEST(Noise, OfASumIsTakenApart) {
  const auto found = noise_of(noise(0.2, 0.1, 5, 50'000), 0.1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->sigma, std::hypot(0.2, 0.1), 0.005);
  EXPECT_NEAR(found->white, 0.2, 0.006);
  EXPECT_NEAR(found->slow, 0.1, 0.015);
  EXPECT_NEAR(found->correlation_s, 5, 1.5);
}

// A running mean over many samples takes 1/n of each out of it: the differences stay those of the
// noise, the deviation does not.
TEST(Noise, OfWhatATrackFollowedIsStillThatOfTheSensor) {
  const auto raw = noise(0.2, 0, 1, 20'000);
  std::vector<double> left;
  for (std::size_t i = 5; i + 5 < raw.size(); ++i) {
    double mean = 0;
    for (std::size_t k = i - 5; k <= i + 5; ++k) mean += raw[k] / 11;
    left.push_back(raw[i] - mean);
  }
  const auto found = noise_of(left, 0.1);
  EXPECT_NEAR(found->white, 0.2, 0.006);
  EXPECT_LT(found->sigma, 0.195);
}

TEST(Noise, OfTooFewValuesIsNotTold) { EXPECT_FALSE(noise_of(noise(1, 0, 1, 9), 0.1)); }

}  // namespace
}  // namespace drydock::twin
