#include "estimators/frame/local_earth.hpp"

#include <gtest/gtest.h>

#include "estimators/frame/earth.hpp"

namespace drydock::frame {
namespace {

TEST(LocalEarth, IsTheEarthOfTheSingleFunctions) {
  for (double latitude = -1.4; latitude < 1.5; latitude += 0.2) {
    for (const double height : {-6000.0, 0.0, 12000.0}) {
      const LocalEarth at = local_earth(latitude, height);
      EXPECT_DOUBLE_EQ(at.transverse_radius_m, transverse_radius(latitude));
      EXPECT_NEAR(at.meridian_radius_m, meridian_radius(latitude), 1e-8);
      EXPECT_NEAR(at.gravity_mps2, gravity(latitude, height), 1e-14);
      EXPECT_DOUBLE_EQ(at.rate_north, earth_rate_ned(latitude).x());
      EXPECT_DOUBLE_EQ(at.rate_down, earth_rate_ned(latitude).z());
    }
  }
}

TEST(LocalEarth, ItsSlopesAreThoseOfTheSingleFunctions) {
  const double latitude = 0.63, height = -300, d = 1e-4;
  const LocalEarth at = local_earth(latitude, height);
  const auto by_latitude = [&](auto&& f) { return (f(latitude + d) - f(latitude - d)) / (2 * d); };
  EXPECT_NEAR(at.meridian_slope_m, by_latitude(meridian_radius), 1e-3);
  EXPECT_NEAR(at.transverse_slope_m, by_latitude(transverse_radius), 1e-3);
  EXPECT_NEAR(at.gravity_by_latitude, by_latitude([&](double l) { return gravity(l, height); }),
              1e-9);
  EXPECT_NEAR(at.gravity_by_height,
              (gravity(latitude, height + 100) - gravity(latitude, height - 100)) / 200, 1e-15);
}

}  // namespace
}  // namespace drydock::frame
