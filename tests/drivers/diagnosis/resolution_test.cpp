#include "drivers/diagnosis/monitors/resolution.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::resolution_test {

/// A sensor at 10 Hz with white noise of 5 mm, whose numbers come in steps of 1 mm.
struct MillimetreSensor : testing::Test {
  std::optional<double> add(double step) {
    now += 0.1;
    const double value = step * std::round((20 + 0.005 * normal(random)) / step);
    return take(value);
  }
  std::optional<double> take(double value) {
    last = {value, last[0], last[1]};
    return resolution.add(last[0] - 2 * last[1] + last[2], at_s(now));
  }
  void learn(double step = 1e-3) {
    for (int i = 0; i < 600; ++i) add(step);
  }
  Resolution resolution;
  std::mt19937_64 random{3};
  std::normal_distribution<double> normal;
  double now = 0;
  std::array<double, 3> last{20, 20, 20};  ///< the latest first
};

TEST_F(MillimetreSensor, HasThatStep) {
  learn();
  ASSERT_TRUE(resolution.known());
  EXPECT_NEAR(resolution.step(), 1e-3, 1e-9);
}

TEST_F(MillimetreSensor, IsToldFromFortyBendsOnThatItRoundsToCentimetres) {
  learn();
  int bends = 0;
  std::optional<double> told;
  while (!told) {
    told = add(0.01);
    bends += last[0] - last[1] != last[1] - last[2] ? 1 : 0;
    ASSERT_LT(bends, 44);
  }
  EXPECT_NEAR(*told, 0.01, 1e-9);
  EXPECT_LT(at_s(now) - resolution.since(), std::chrono::seconds{20});
  while (add(1e-3))
    ;  // one millimetre ends it
  EXPECT_LT(now, 90);
}

TEST_F(MillimetreSensor, IsHealthyForADayAndFinerStepsAreNoSign) {
  learn();
  for (int i = 0; i < 864'000; ++i) ASSERT_FALSE(add(1e-3)) << i;
  for (int i = 0; i < 36'000; ++i) ASSERT_FALSE(add(1e-4)) << i;
}

TEST_F(MillimetreSensor, HasNoStepWhereItsNumbersAreTurnedByAMounting) {
  for (int i = 0; i < 3000; ++i) {
    now += 0.1;
    const auto read = [&] { return 1e-3 * std::round(5 * normal(random)); };
    const double value = std::cos(0.3) * read() + std::sin(0.3) * read();
    take(value);
  }
  EXPECT_FALSE(resolution.known());
}

TEST_F(MillimetreSensor, IsNotCoarseInASteadyTurnWithoutNoise) {
  learn();
  for (int i = 1; i < 600; ++i) {
    now += 0.1;
    ASSERT_FALSE(take(20 + 0.120 * i)) << i;
  }
}

}  // namespace drydock::diagnosis::resolution_test
