#include "drivers/device/gnss/ecef.hpp"

#include <cmath>

#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace ecef_test {

constexpr double a = 6'378'137.0, f = 1 / 298.257223563;  // WGS-84

TEST(Ecef, PointsOnTheAxesAreKnownWithoutIteration) {
  const auto equator = from_ecef({0, a + 100, 0});
  EXPECT_NEAR(equator.horizontal.latitude_rad, 0, 1e-15);
  EXPECT_NEAR(equator.horizontal.longitude_rad, 90 * degree, 1e-15);
  EXPECT_NEAR(equator.height_m, 100, 1e-8);
  const auto pole = from_ecef({0, 0, -a * (1 - f) + 30});
  EXPECT_NEAR(pole.horizontal.latitude_rad, -90 * degree, 1e-15);
  EXPECT_NEAR(pole.height_m, -30, 1e-8);
}

/// The closed form of the forward conversion: x = (N + h) cos(lat) cos(lon), ..., z = (N (1 - e2) +
/// h) sin(lat).
TEST(Ecef, TheWayBackFindsEveryPlaceAgain) {
  const double e2 = f * (2 - f);
  for (double latitude = -90; latitude <= 90; latitude += 7.5) {
    for (const double height : {-11'000.0, 0.0, 10'000.0}) {
      const double sine = std::sin(latitude * degree), cosine = std::cos(latitude * degree);
      const double n = a / std::sqrt(1 - e2 * sine * sine);
      const double longitude = 2 * latitude - 0.1;
      const auto found = from_ecef({(n + height) * cosine * std::cos(longitude * degree),
                                    (n + height) * cosine * std::sin(longitude * degree),
                                    (n * (1 - e2) + height) * sine});
      EXPECT_NEAR(found.horizontal.latitude_rad, latitude * degree, 2e-15);
      EXPECT_NEAR(found.height_m, height, 5e-9);
      if (std::abs(latitude) < 89) {
        EXPECT_NEAR(std::remainder(found.horizontal.longitude_rad - longitude * degree,
                                   2 * std::numbers::pi),
                    0, 1e-14);
      }
    }
  }
}

TEST(Ecef, NorthEastAndDownAreTheAxesOfThePlace) {
  const measurement::Geodetic zero{0, 0}, turned{0, 90 * degree}, north_pole{90 * degree, 0};
  EXPECT_NEAR((ned_of_ecef({1, 2, 3}, zero) - Eigen::Vector3d(3, 2, -1)).norm(), 0, 1e-15);
  EXPECT_NEAR((ned_of_ecef({1, 2, 3}, turned) - Eigen::Vector3d(3, -1, -2)).norm(), 0, 1e-15);
  EXPECT_NEAR((ned_of_ecef({1, 2, 3}, north_pole) - Eigen::Vector3d(-1, 2, -3)).norm(), 0, 1e-15);
}

}  // namespace ecef_test
}  // namespace drydock::device::test
