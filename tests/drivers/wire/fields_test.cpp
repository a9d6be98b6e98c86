#include "drivers/wire/fields.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

/// Angles are radians inside and degrees for the reader. The shown value is the one that the device
/// sent.
namespace drydock::wire {
namespace fields_test {

TEST(Degrees, ThoseThatADeviceSentComeBackToTheLastDigit) {
  EXPECT_EQ(degrees(radians(3.0)), 3.0);
  EXPECT_EQ(degrees(radians(3.12)), 3.12);
  EXPECT_EQ(degrees(radians(-33.9456789)), -33.9456789);
  EXPECT_EQ(degrees(radians(0.0)), 0.0);
}

RC_GTEST_PROP(Degrees, EveryPositionOfAReceiverComesBackToTheLastDigit, ()) {
  const auto sent = *rc::gen::inRange<std::int32_t>(-1'800'000'000, 1'800'000'001);
  RC_ASSERT(degrees(radians(sent / 1e7)) == sent / 1e7);
}

RC_GTEST_PROP(Degrees, OfAnyAngleAreRightToTheFifteenthDigit, (double angle_rad)) {
  const double expected = static_cast<double>(angle_rad * (180.0L / 3.14159265358979323846L));
  RC_ASSERT(std::abs(degrees(angle_rad) - expected) <= 1e-15 * std::abs(expected));
}

TEST(Degrees, OfNoNumberAreNone) {
  EXPECT_TRUE(std::isnan(degrees(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isinf(degrees(std::numeric_limits<double>::infinity())));
}

}  // namespace fields_test
}  // namespace drydock::wire
