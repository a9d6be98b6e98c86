#include "estimators/consistency/current.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drydock::consistency {
namespace {

/// What a log that is off by 0.05 m/s ahead lacks in a current of 0.3 m/s to the north.
Eigen::Vector2d lacking(double heading) {
  return {0.3 * std::cos(heading) - 0.05, -0.3 * std::sin(heading)};
}

TEST(Current, IsKnownOnAllHeadingsAfterACircle) {
  Current current;
  for (int i = 0; i < 120; ++i) {
    const double heading = 2 * std::numbers::pi * i / 120;
    current.follow(lacking(heading), true, heading, 0.5);
  }
  for (const double heading : {0.0, 1.0, 2.0, 4.0})
    EXPECT_LT((current.at(heading) - lacking(heading)).norm(), 0.03);
  EXPECT_LT(std::sqrt(current.variance(1.0)), 0.05);
}

TEST(Current, StaysUncertainAcrossUntilTheVehicleTurns) {
  Current current;
  for (int i = 0; i < 120; ++i) current.follow(lacking(0), false, 0, 0.5);
  EXPECT_LT(std::sqrt(current.variance(0)), 0.05);
  EXPECT_GT(std::sqrt(current.variance(std::numbers::pi / 2)), 0.4);
}

/// The axes of a DVL are inverted from one sample to the next: no water does that.
TEST(Current, LearnsNothingFromAJumpOfTheVelocityOverGround) {
  Current current;
  for (int i = 0; i < 120; ++i) current.follow(lacking(0), false, 0, 0.5);
  for (int i = 0; i < 120; ++i) current.follow(lacking(0) - Eigen::Vector2d{4, 0}, false, 0, 0.5);
  EXPECT_NEAR(current.at(0).x(), lacking(0).x(), 0.02);
}

}  // namespace
}  // namespace drydock::consistency
