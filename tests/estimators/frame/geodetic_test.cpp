#include "estimators/frame/geodetic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "estimators/frame/earth.hpp"

namespace drydock::frame {
namespace {

using Eigen::Vector3d;

constexpr double deg = std::numbers::pi / 180;

void expect_same(const Position& a, const Position& b, double metres) {
  EXPECT_NEAR(a.latitude_rad, b.latitude_rad, metres / 6.4e6);
  EXPECT_NEAR(a.longitude_rad, b.longitude_rad, metres / 6.4e6);
  EXPECT_NEAR(a.height_m, b.height_m, metres);
}

TEST(Geodetic, AxesOfTheEllipsoidAreKnownPoints) {
  EXPECT_LT((ecef({0, 0, 0}) - Vector3d{6378137, 0, 0}).norm(), 1e-8);
  EXPECT_LT((ecef({0, 90 * deg, 10}) - Vector3d{0, 6378147, 0}).norm(), 1e-8);
  EXPECT_LT((ecef({90 * deg, 0, -5}) - Vector3d{0, 0, 6356752.3142 - 5}).norm(), 1e-4);
}

TEST(Geodetic, APointThatAnotherProgramConverted) {
  // PROJ manual, conversion "cart". It is on GRS80, which differs from WGS-84 by .1 mm here.
  const Position geographic{45.3935192042 * deg, 17.7562015132 * deg, 133.12};
  const Vector3d geocentric{4272922.1553, 1368283.0597, 4518261.3501};
  EXPECT_LT((ecef(geographic) - geocentric).norm(), 5e-4);
  expect_same(geodetic(geocentric), geographic, 5e-4);
}

TEST(Geodetic, TheWayBackClosesFromTheSeaBedToSatellites) {
  for (const double height : {-11000., -300., 0., 8848., 400e3, 20200e3, 40000e3}) {
    for (double latitude = -90; latitude <= 90; latitude += 7.5) {
      const Position there{latitude * deg, 1.1, height};
      const Vector3d point = ecef(there);
      EXPECT_LT((ecef(geodetic(point)) - point).norm(), 2e-8);
      EXPECT_NEAR(geodetic(point).height_m, height, 2e-8);
      EXPECT_NEAR(geodetic(point).latitude_rad, there.latitude_rad, 1e-15);
    }
  }
}

TEST(Geodetic, NedAxesPointNorthEastAndDown) {
  const Position here{36 * deg, 129 * deg, 0};
  const double little = 1e-7;
  const Vector3d north = ned_offset(here, {here.latitude_rad + little, here.longitude_rad, 0});
  const Vector3d east = ned_offset(here, {here.latitude_rad, here.longitude_rad + little, 0});
  const Vector3d down = ned_offset(here, {here.latitude_rad, here.longitude_rad, -1});
  EXPECT_NEAR(north.x(), little * meridian_radius(here.latitude_rad), 1e-6);
  EXPECT_NEAR(east.y(), little * transverse_radius(here.latitude_rad) * std::cos(here.latitude_rad),
              1e-6);
  EXPECT_LT((down - Vector3d{0, 0, 1}).norm(), 1e-8);
}

TEST(Geodetic, AnOffsetThereAndBackCloses) {
  const Position origin{-41.3 * deg, 174.8 * deg, 12};
  const Vector3d offset{12345, -6789, 321};
  EXPECT_LT((ned_offset(origin, at_ned_offset(origin, offset)) - offset).norm(), 1e-8);
}

}  // namespace
}  // namespace drydock::frame
