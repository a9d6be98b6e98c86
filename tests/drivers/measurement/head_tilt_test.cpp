#include "drivers/measurement/head_tilt.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace drydock::measurement::head_tilt_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Teledyne, ADCP Coordinate Transformation (2010): pitch = atan(tan(tilt 1) cos(tilt 2)).
TEST(HeadTilt, TheGimbalsPitchBecomesEulers) {
  BottomVelocity track;
  track.roll_rad = 60 * degree;
  track.pitch_rad = 45 * degree;
  const auto tilt = head_tilt(track);
  ASSERT_TRUE(tilt);
  EXPECT_DOUBLE_EQ(tilt->roll_rad, 60 * degree);
  EXPECT_NEAR(tilt->pitch_rad, std::atan(0.5), 1e-15);
}

TEST(HeadTilt, OneAngleAloneIsNoTilt) {
  BottomVelocity track;
  EXPECT_FALSE(head_tilt(track));
  track.pitch_rad = 1 * degree;
  EXPECT_FALSE(head_tilt(track));
  track.roll_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(head_tilt(track));
}

}  // namespace
}  // namespace drydock::measurement::head_tilt_test
