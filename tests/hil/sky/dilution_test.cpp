#include "hil/sky/dilution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace drydock::sky {
namespace dilution_test {

constexpr double degree = std::numbers::pi / 180;

measurement::Satellite satellite(double elevation_deg, double azimuth_deg) {
  measurement::Satellite s;
  s.elevation_rad = elevation_deg * degree;
  s.azimuth_rad = azimuth_deg * degree;
  s.used = true;
  return s;
}

std::vector<measurement::Satellite> zenith_and_three_at(double elevation_deg) {
  return {satellite(90, 0), satellite(elevation_deg, 10), satellite(elevation_deg, 130),
          satellite(elevation_deg, 250)};
}

// H'H separates into north, east and [down, time]. Their inverses are written by hand.
TEST(Dilution, OfOneAtTheZenithAndThreeOnTheHorizonIsKnown) {
  const auto d = dilution(zenith_and_three_at(0)).value();
  EXPECT_NEAR(d.horizontal, std::sqrt(4.0 / 3), 1e-12);
  EXPECT_NEAR(d.vertical, std::sqrt(4.0 / 3), 1e-12);
  EXPECT_NEAR(d.position, std::sqrt(8.0 / 3), 1e-12);
  EXPECT_NEAR(d.time, std::sqrt(1.0 / 3), 1e-12);
  EXPECT_NEAR(d.geometric, std::sqrt(3.0), 1e-12);
}

// The minimum for four satellites is a regular tetrahedron, sqrt(5/2).
TEST(Dilution, OfARegularTetrahedronIsTheLeastOfFour) {
  const double below = -std::asin(1.0 / 3) / degree;
  EXPECT_NEAR(dilution(zenith_and_three_at(below))->geometric, std::sqrt(2.5), 1e-12);
}

TEST(Dilution, IsNotThereWhereNoPositionIs) {
  auto sky = zenith_and_three_at(20);
  sky[2].used = false;
  EXPECT_FALSE(dilution(sky)) << "three";
  EXPECT_FALSE(dilution({}));
  std::vector<measurement::Satellite> cone;
  for (int i = 0; i < 8; ++i) cone.push_back(satellite(30, 45 * i));
  EXPECT_FALSE(dilution(cone)) << "height and clock cannot be told apart";
}

TEST(Dilution, FallsWithEachSatellite) {
  auto sky = zenith_and_three_at(15);
  double before = dilution(sky)->geometric;
  for (int i = 0; i < 6; ++i) {
    sky.push_back(satellite(10 + 12 * i, 77 * i));
    const double now = dilution(sky)->geometric;
    EXPECT_LT(now, before);
    before = now;
  }
}

}  // namespace dilution_test
}  // namespace drydock::sky
