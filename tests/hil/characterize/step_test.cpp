#include "hil/characterize/noise/step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hil/characterize/noise/steadiness.hpp"
#include "hil/sensor/random.hpp"

namespace drydock::characterize {
namespace step_test {

std::vector<double> noise(double sigma, std::size_t count) {
  sensor::RandomStream random(1, "sensor", "step");
  std::vector<double> values(count);
  for (double& value : values) value = sigma * random.normal();
  return values;
}

TEST(QuantisationStep, IsFoundUnderNoiseAndAnOffset) {
  for (const double sigma_in_steps : {0.6, 5.0, 200.0}) {
    constexpr double step = 0.00732421875e-3;
    auto values = noise(sigma_in_steps * step, 20'000);
    for (double& value : values) value = 0.1234 + step * std::round(value / step);
    const auto found = quantisation_step(values);
    ASSERT_TRUE(found) << sigma_in_steps;
    EXPECT_NEAR(*found / step, 1, 1e-6) << sigma_in_steps;
  }
}

TEST(QuantisationStep, WhereGapsAreNoMultiplesOfTheSmallestNothingIsClaimed) {
  std::vector<double> values;
  for (int k = 0; k < 100; ++k)
    for (const int place : {0, 3, 8, 10}) values.push_back(0.25 * place);
  // Gaps of 3, 5 and 2 quarters.
  EXPECT_FALSE(quantisation_step(values));
}

TEST(QuantisationStep, OfContinuousReadingsThereIsNone) {
  EXPECT_FALSE(quantisation_step(noise(1, 20'000)));
  EXPECT_FALSE(quantisation_step(std::vector<double>(100, 7.0)));
  EXPECT_FALSE(quantisation_step({}));
}

TEST(Steadiness, NoiseAndSlowDriftAreRestATurnIsNot) {
  auto values = noise(0.01, 60'000);
  EXPECT_TRUE(steadiness_of(values, 0.01, 0.002).steady);
  for (std::size_t i = 20'000; i < 25'000; ++i) values[i] += 0.1;
  const auto moving = steadiness_of(values, 0.01, 0.002);
  EXPECT_FALSE(moving.steady);
  EXPECT_NEAR(moving.change, 0.1, 0.01);
}

}  // namespace step_test
}  // namespace drydock::characterize
