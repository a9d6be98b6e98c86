#include "estimators/mixing/stepped_angle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace drydock::mixing::stepped_angle_test {
namespace {

TEST(SteppedAngle, ItsSineAndCosineAreThoseOfTheAngleAfterAMillionSteps) {
  std::mt19937_64 random(3);
  // Most steps are small and give a slow turn. Some steps are too large for the series.
  std::normal_distribution<double> small(0.001, 0.003);
  std::uniform_real_distribution<double> large(-3, 3);
  SteppedAngle angle(0.3);
  double least = 0, most = 0, worst = 0;
  for (int i = 1; i <= 1'000'000; ++i) {
    angle.add(i % 10'000 == 0 ? large(random) : small(random));
    worst = std::max({worst, std::abs(angle.sine() - std::sin(angle.angle())),
                      std::abs(angle.cosine() - std::cos(angle.angle()))});
    least = std::min(least, angle.angle());
    most = std::max(most, angle.angle());
  }
  EXPECT_LT(worst, 1e-13);
  EXPECT_GE(least, -std::numbers::pi);
  EXPECT_LE(most, std::numbers::pi);
  EXPECT_GT(most - least, 6.28);  // at least a full turn
}

TEST(SteppedAngle, GoesOnAcrossTheBorder) {
  SteppedAngle angle(std::numbers::pi - 0.001);
  angle.add(0.002);
  EXPECT_NEAR(angle.angle(), -std::numbers::pi + 0.001, 1e-15);
  EXPECT_NEAR(angle.sine(), -0.001, 1e-9);
}

}  // namespace
}  // namespace drydock::mixing::stepped_angle_test
