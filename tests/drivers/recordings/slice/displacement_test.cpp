#include "drivers/recordings/slice/displacement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drivers/device/gnss/ecef.hpp"

namespace drydock::slice {
namespace displacement_test {

constexpr double degree = std::numbers::pi / 180;

double metres_between(const measurement::Geodetic& a, const measurement::Geodetic& b) {
  return (device::to_ecef({a, 0}) - device::to_ecef({b, 0})).norm();
}

TEST(Displacement, KeepsTheMetresOfATrack) {
  const measurement::Geodetic start{54.3 * degree, 10.1 * degree};
  Displacement place({0, -30 * degree});
  place.start_at(start);
  const measurement::Geodetic north{54.31 * degree, 10.1 * degree},
      east{54.3 * degree, 10.12 * degree};
  EXPECT_NEAR(metres_between(place(start), place(north)), metres_between(start, north), 0.2);
  EXPECT_NEAR(metres_between(place(start), place(east)), metres_between(start, east), 0.01);
  EXPECT_NEAR(place(start).latitude_rad, 0, 1e-15);
  EXPECT_NEAR(place(start).longitude_rad, -30 * degree, 1e-15);
}

TEST(Displacement, GoesTheShortWayOverTheDateLine) {
  Displacement place({0, 0});
  place.start_at({0, 179.9 * degree});
  EXPECT_NEAR(place.longitude(-179.9 * degree), 0.2 * degree, 1e-12);
}

// One degree of latitude at the equator is 110574 m, one of longitude 111320 m (WGS-84, any table).
TEST(Displacement, EarthCentredAxesAreRightAtTheEquator) {
  EXPECT_NEAR(metres_between({0, 0}, {degree, 0}), 110574, 2);
  EXPECT_NEAR(metres_between({0, 0}, {0, degree}), 111320, 2);
  const Eigen::Vector3d ned{1, 2, 3};
  const measurement::Geodetic at{-0.7, 2.1};
  EXPECT_LT((device::ned_of_ecef(device::ecef_of_ned(ned, at), at) - ned).norm(), 1e-15);
}

}  // namespace displacement_test
}  // namespace drydock::slice
