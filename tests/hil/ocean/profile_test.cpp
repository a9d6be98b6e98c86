#include "hil/ocean/profile.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace drydock::ocean {
namespace profile_test {

/// Knots from numbers that rapidcheck draws. Each depth is 1 m to 100 m below the last.
std::vector<Profile::Knot> drawn() {
  const auto count = *rc::gen::inRange(1, 7);
  std::vector<Profile::Knot> knots;
  double depth = 0;
  for (int i = 0; i < count; ++i) {
    knots.push_back({depth, *rc::gen::inRange(-1000, 1000) / 1000.0});
    depth += *rc::gen::inRange(1, 100);
  }
  return knots;
}

TEST(OceanProfile, WithoutKnotsItIsZeroAndWithOneConstant) {
  EXPECT_EQ(Profile().value(5), 0);
  EXPECT_EQ(Profile().integral(5), 0);
  const Profile one({{10, 3}});
  EXPECT_EQ(one.value(0), 3);
  EXPECT_EQ(one.slope(50), 0);
  EXPECT_DOUBLE_EQ(one.integral(50), 150);
}

TEST(OceanProfile, BetweenTwoKnotsItIsTheCubicStep) {
  const Profile profile({{10, 1}, {30, 2}});
  for (const double x : {0.1, 0.5, 0.8}) {
    EXPECT_NEAR(profile.value(10 + 20 * x), 1 + x * x * (3 - 2 * x), 1e-15);
    EXPECT_NEAR(profile.slope(10 + 20 * x), 6 * x * (1 - x) / 20, 1e-15);
    // The integral of 1 + 3 x^2 - 2 x^3 over 20 m, plus 10 m of the value 1 above.
    EXPECT_NEAR(profile.integral(10 + 20 * x), 10 + 20 * (x + x * x * x - x * x * x * x / 2),
                1e-12);
  }
}

RC_GTEST_PROP(OceanProfile, GoesThroughItsKnotsAndNeverBeyondTheTwoAround, ()) {
  const auto knots = drawn();
  const Profile profile(knots);
  for (const auto& knot : knots)
    RC_ASSERT(std::abs(profile.value(knot.depth_m) - knot.value) < 1e-12);
  for (std::size_t i = 1; i < knots.size(); ++i)
    for (int part = 0; part <= 20; ++part) {
      const auto [above, below] = std::pair(knots[i - 1], knots[i]);
      const double v = profile.value(above.depth_m + part / 20.0 * (below.depth_m - above.depth_m));
      RC_ASSERT(v > std::min(above.value, below.value) - 1e-12);
      RC_ASSERT(v < std::max(above.value, below.value) + 1e-12);
    }
}

RC_GTEST_PROP(OceanProfile, ItsSlopeIsItsDerivativeAndItselfThatOfItsIntegral, ()) {
  const Profile profile(drawn());
  const double z = *rc::gen::inRange(-1000, 60000) / 100.0, h = 1e-4;
  const auto difference = [&](auto f) { return (f(z + h) - f(z - h)) / (2 * h); };
  RC_ASSERT(std::abs(difference([&](double d) { return profile.value(d); }) - profile.slope(z)) <
            1e-3);
  RC_ASSERT(std::abs(difference([&](double d) { return profile.integral(d); }) - profile.value(z)) <
            1e-6);
}

}  // namespace profile_test
}  // namespace drydock::ocean
