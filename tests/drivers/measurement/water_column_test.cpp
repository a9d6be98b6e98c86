#include "drivers/measurement/water_column.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

namespace drydock::measurement {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double decibar = 1e4;

struct Check {
  double decibars, latitude_deg, depth_m;
};

// UNESCO Technical Papers in Marine Science 44, table of depths and its check value.
constexpr Check table[] = {
    {500, 0, 496.65},    {500, 30, 496.00},   {500, 90, 494.03},    {1000, 45, 989.50},
    {2000, 60, 1971.72}, {5000, 0, 4915.04},  {5000, 45, 4902.08},  {5000, 90, 4889.13},
    {9000, 30, 8759.51}, {10000, 0, 9725.47}, {10000, 45, 9699.84}, {10000, 90, 9674.23},
};

TEST(UnescoDepth, IsThatOfTheReportsTable) {
  EXPECT_NEAR(unesco_depth_m(10000 * decibar, 30 * degree), 9712.653, 5e-4);
  for (const Check& c : table) {
    EXPECT_NEAR(unesco_depth_m(c.decibars * decibar, c.latitude_deg * degree), c.depth_m, 5.1e-3)
        << c.decibars << " dbar at " << c.latitude_deg << " deg";
  }
}

TEST(UnescoDepth, IsTheSameNorthAndSouth) {
  EXPECT_EQ(unesco_depth_m(5e6, -47 * degree), unesco_depth_m(5e6, 47 * degree));
}

TEST(UnescoPressure, IsTheReportsTableReadBackwards) {
  EXPECT_NEAR(unesco_pressure_pa(9712.653, 30 * degree), 10000 * decibar, 6e-4 * decibar);
  for (const Check& c : table) {
    EXPECT_NEAR(unesco_pressure_pa(c.depth_m, c.latitude_deg * degree), c.decibars * decibar,
                5.4e-3 * decibar);
  }
}

RC_GTEST_PROP(UnescoPressure, IsTheInverseToAMicrometre, ()) {
  const double depth = *rc::gen::inRange(0, 11'000'000) / 1000.0;
  const double latitude = *rc::gen::inRange(-90, 91) * degree;
  const double back = unesco_depth_m(unesco_pressure_pa(depth, latitude), latitude);
  RC_ASSERT(std::abs(back - depth) < 1e-6);
}

TEST(WaterColumn, TakesTheOceanWhereALatitudeIsGivenElseOneDensity) {
  WaterColumn water{101'325, 1000, {}};
  EXPECT_NEAR(water.depth_m(101'325 + 9806.65), 1, 1e-12);
  water.unesco_latitude_rad = 30 * degree;
  EXPECT_NEAR(water.depth_m(101'325 + 10000 * decibar), 9712.653, 5e-4);
}

}  // namespace
}  // namespace drydock::measurement
