#include "hil/characterize/noise/noise_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hil/sensor/random.hpp"

namespace drydock::characterize {
namespace noise_fit_test {

/// Readings with the given processes. Each process is stepped exactly.
std::vector<double> readings_of(const NoiseModel& model, double period_s, std::size_t count,
                                std::uint64_t seed) {
  sensor::RandomStream random(seed, "sensor", "test");
  const double memory = model.instability > 0 ? std::exp(-period_s / model.correlation_s) : 0;
  double markov = model.instability * random.normal(), walk = 0, rest = 0;
  std::vector<double> readings;
  for (std::size_t k = 0; k < count; ++k) {
    const double next_rest = model.quantisation * random.normal();
    readings.push_back(model.density / std::sqrt(period_s) * random.normal() + markov + walk +
                       (next_rest - rest) / period_s);
    rest = next_rest;
    markov = memory * markov + model.instability * std::sqrt(1 - memory * memory) * random.normal();
    walk += model.walk * std::sqrt(period_s) * random.normal();
  }
  return readings;
}

/// The number of forty recordings whose bounds hold the true figure: 38 on average.
template <class Holds>
int within(const NoiseModel& model, Holds holds) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto fit = fit_noise(allan_curve(readings_of(model, 0.01, 8192, seed), 0.01));
    count += fit && holds(*fit) ? 1 : 0;
  }
  return count;
}

TEST(NoiseFit, WhiteNoiseAloneIsFoundWithinItsBoundsAndNothingElseIsSeen) {
  const NoiseModel model{.density = 0.2};
  EXPECT_GE(
      within(model, [](const NoiseFit& fit) { return fit.density && fit.density->holds(0.2); }),
      34);
  EXPECT_GE(within(model,
                   [](const NoiseFit& fit) {
                     return !fit.instability && !fit.walk && !fit.quantisation;
                   }),
            36);
}

TEST(NoiseFit, AWalkIsFoundBesideWhiteNoise) {
  EXPECT_GE(within({.density = 0.1, .walk = 0.3},
                   [](const NoiseFit& fit) {
                     return fit.density->holds(0.1) && fit.walk && fit.walk->holds(0.3);
                   }),
            32);
}

TEST(NoiseFit, ACarriedQuantisationIsFoundBesideWhiteNoise) {
  EXPECT_GE(
      within({.quantisation = 0.05, .density = 0.1},
             [](const NoiseFit& fit) { return fit.quantisation && fit.quantisation->holds(0.05); }),
      34);
}

TEST(NoiseFit, AGaussMarkovProcessIsFoundWithItsCorrelationTime) {
  EXPECT_GE(within({.density = 0.02, .instability = 1, .correlation_s = 0.5},
                   [](const NoiseFit& fit) {
                     return fit.instability && fit.instability->holds(1) &&
                            fit.correlation_s->holds(0.5);
                   }),
            32);
}

TEST(NoiseFit, BoundsDoNotDependOnTheUnit) {
  auto readings =
      readings_of({.density = 0.02, .instability = 1, .correlation_s = 0.5}, 0.01, 8192, 1);
  const auto large = fit_noise(allan_curve(readings, 0.01)).value();
  for (double& reading : readings) reading *= 1e-5;
  const auto small = fit_noise(allan_curve(readings, 0.01)).value();
  ASSERT_TRUE(large.correlation_s && small.correlation_s);
  EXPECT_NEAR(small.correlation_s->low / large.correlation_s->low, 1, 1e-3);
  EXPECT_NEAR(small.instability->high / large.instability->high * 1e5, 1, 1e-3);
  EXPECT_GT(large.correlation_s->high, 1.2 * large.correlation_s->low);
}

TEST(NoiseFit, OfReadingsThatAreAllEqualThereIsNone) {
  EXPECT_FALSE(fit_noise(allan_curve(std::vector<double>(1000, 5.0), 0.01)));
  EXPECT_FALSE(fit_noise(allan_curve(std::vector<double>{1, 2, 3}, 0.01)));
}

TEST(DeviationEstimate, HasTheChiSquareBoundsOfTheTables) {
  // Ten degrees of freedom: 3.247 and 20.483 at 2.5 % and 97.5 %.
  const double variance = 4, sigma = variance * std::sqrt(2.0 / 10);
  const auto estimate = deviation_estimate(variance, sigma);
  EXPECT_DOUBLE_EQ(estimate.value, 2);
  EXPECT_NEAR(estimate.low, std::sqrt(variance * 10 / 20.483), 1e-3);
  EXPECT_NEAR(estimate.high, std::sqrt(variance * 10 / 3.247), 1e-3);
}

}  // namespace noise_fit_test
}  // namespace drydock::characterize
