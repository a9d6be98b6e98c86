#include "estimators/consistency/first_offset.hpp"

#include <gtest/gtest.h>

namespace drydock::consistency {
namespace {

using Of = FirstOffset::Of;

/// DVL, receiver and log of a vehicle at 2 m/s read these, m/s.
std::optional<FirstOffset> of_reading(double dvl, double receiver, double log,
                                      double sigma = 0.02) {
  return first_offset(dvl - receiver, dvl - log, sigma);
}

TEST(FirstOffset, IsOfTheOneWithWhomTheTwoOthersDoNotAgree) {
  const auto log = of_reading(2, 2.02, 3), dvl = of_reading(2.5, 2, 1.95),
             receiver = of_reading(2, 1.5, 2.1);
  ASSERT_TRUE(log && dvl && receiver);
  EXPECT_EQ(log->of, Of::log);
  EXPECT_NEAR(log->off_mps, 1, 1e-9);
  EXPECT_EQ(dvl->of, Of::dvl);
  EXPECT_NEAR(dvl->off_mps, 0.5, 1e-9);
  EXPECT_EQ(receiver->of, Of::receiver);
  EXPECT_NEAR(receiver->off_mps, -0.5, 1e-9);
}

TEST(FirstOffset, IsOfNobodyWhereNoTwoAgree) { EXPECT_FALSE(of_reading(2, 2.5, 3)); }

TEST(FirstOffset, IsNoneOfSoundSensorsNorBeforeATurnToldTheCurrent) {
  EXPECT_FALSE(of_reading(2, 2.05, 2.2));
  EXPECT_FALSE(of_reading(2, 2, 3, 0.3));
}

}  // namespace
}  // namespace drydock::consistency
