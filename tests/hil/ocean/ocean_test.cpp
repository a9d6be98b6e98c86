#include "hil/ocean/ocean.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "estimators/frame/geodetic.hpp"

namespace drydock::ocean {
namespace ocean_test {

using Eigen::Vector3d;
using rig_config::BedKind;
using rig_config::OceanConfig;
using rig_config::WaterKind;

constexpr double degree = std::numbers::pi / 180;
const frame::Position origin{36 * degree, 129 * degree, 0};

frame::Position offset(double north, double east, double down) {
  return frame::at_ned_offset(origin, {north, east, down});
}

OceanConfig slope(double gradient, double downhill_deg) {
  OceanConfig config;
  config.bed.kind = BedKind::slope;
  config.bed.depth_m = 60;
  config.bed.gradient = gradient;
  config.bed.downhill_rad = downhill_deg * degree;
  return config;
}

TEST(Ocean, ASlopeGoesDownInItsDirectionByItsGradient) {
  const Ocean ocean(slope(0.05, 90), origin);
  const auto depth = [&](const frame::Position& p) {
    return ocean.bed_depth_m(p.latitude_rad, p.longitude_rad);
  };
  EXPECT_NEAR(depth(origin), 60, 1e-9);
  EXPECT_NEAR(depth(offset(0, 400, 0)), 80, 1e-3);
  EXPECT_NEAR(depth(offset(300, -400, 0)), 40, 1e-3);
}

TEST(Ocean, ABeamMeetsASlopeWhereTrigonometrySays) {
  const double gradient = std::tan(20 * degree);
  const Ocean ocean(slope(gradient, 0), origin);
  const auto from = offset(0, 0, 10);
  // 50 m above the bed, a beam 30 deg off the vertical, downhill and uphill: sine rule in the
  // triangle of plumb line, beam and bed.
  const double s30 = std::sin(30 * degree), c30 = std::cos(30 * degree);
  EXPECT_NEAR(*ocean.bed_range_m(from, {s30, 0, c30}, 500),
              50 * std::cos(20 * degree) / std::cos(50 * degree), 1e-6);
  EXPECT_NEAR(*ocean.bed_range_m(from, {-s30, 0, c30}, 500),
              50 * std::cos(20 * degree) / std::cos(10 * degree), 1e-6);
  EXPECT_NEAR(*ocean.bed_range_m(from, {0, s30, c30}, 500), 50 / c30, 1e-6);
  EXPECT_FALSE(ocean.bed_range_m(from, {s30, 0, c30}, 73));
  EXPECT_FALSE(ocean.bed_range_m(from, {std::cos(15 * degree), 0, std::sin(15 * degree)}, 1e5));
}

TEST(Ocean, ARasterInDegreesLiesWhereItsHeaderSaysAndCountsHeights) {
  OceanConfig config;
  config.bed.kind = BedKind::raster;
  config.bed.file = testing::TempDir() + "ocean_test.asc";
  std::ofstream(config.bed.file) << "ncols 2\nnrows 2\nxllcenter 489\nyllcenter 36\ncellsize 0.01\n"
                                    "-50 -60\n-30 -40\n";
  const Ocean ocean(config, origin);
  EXPECT_NEAR(ocean.bed_depth_m(36 * degree, 129 * degree), 30, 1e-5);
  EXPECT_NEAR(ocean.bed_depth_m(36.01 * degree, 129.01 * degree), 60, 1e-5);
  EXPECT_NEAR(ocean.bed_depth_m(36.005 * degree, 129.0025 * degree), 42.5, 1e-5);
  std::ofstream(config.bed.file) << "ncols 2\n";
  EXPECT_THROW(Ocean(config, origin), std::invalid_argument);
}

TEST(Ocean, TheCurrentsRateIsItsDerivativeAlongTheVehiclesWay) {
  OceanConfig config;
  config.current = {{0, {0.5, 0.1, 0}}, {20, {0.2, 0.3, 0}}, {80, {-0.1, 0.2, 0.01}}};
  config.tide = {600, 0.7, {0.3, -0.2, 0}};
  const Ocean ocean(config, origin);
  const double sink = 0.8, h = 1e-4;
  for (double t = 0; t < 100; t += 0.37) {
    const auto at = [&](double time) { return ocean.current_ned(sink * time, time); };
    const Vector3d expected = (at(t + h) - at(t - h)) / (2 * h);
    EXPECT_LT((ocean.current_rate_ned(sink * t, sink, t) - expected).norm(), 1e-6) << t;
  }
}

TEST(Ocean, TheTideIsASinusoidOfItsPeriodAndPhase) {
  OceanConfig config;
  config.tide = {44714, 90 * degree, {0.4, -0.2, 0}};
  const Ocean ocean(config, origin);
  EXPECT_LT((ocean.current_ned(5, 0) - Vector3d(0.4, -0.2, 0)).norm(), 1e-12);
  EXPECT_LT(ocean.current_ned(5, 44714 / 4.0).norm(), 1e-12);
  EXPECT_LT((ocean.current_ned(50, 44714 / 2.0) + Vector3d(0.4, -0.2, 0)).norm(), 1e-12);
}

TEST(Ocean, PressureIsTheIntegralOfDensity) {
  OceanConfig config;
  config.water.kind = WaterKind::layered;
  config.water.density = {{10, 1000}, {30, 1030}};
  const Ocean ocean(config, origin);
  const double gravity = 9.798191;  // Somigliana at 36 deg
  // By symmetry the 20 m of the step weigh as much as water of 1015 kg/m3.
  const double column = 10 * 1000 + 20 * 1015 + 70 * 1030;
  EXPECT_NEAR(ocean.pressure_pa(100, 36 * degree), 101'325 + gravity * column, 1);
  EXPECT_EQ(ocean.pressure_pa(-2, 36 * degree), 101'325);
  double sum = 0;
  for (int i = 0; i < 10'000; ++i) sum += ocean.density_kgm3((i + 0.5) / 100) / 100;
  EXPECT_NEAR(sum, column, 1e-3);
}

TEST(Ocean, TheStandardOceanHasTheDensityOfTheUnescoReport) {
  OceanConfig config;
  config.water.kind = WaterKind::standard;
  const Ocean ocean(config, {30 * degree, 0, 0});
  // UNESCO 44: at S = 35 and 0 deg C the surface density is 1028.106 kg/m3, and 10000 dbar is at a
  // depth of 9712.653 m.
  EXPECT_NEAR(ocean.density_kgm3(0), 1028.106, 0.01);
  EXPECT_NEAR(ocean.pressure_pa(9712.653, 30 * degree), 101'325 + 1e8, 10);
}

TEST(Ocean, SoundIsAsFastAsInMedwinsFormula) {
  // H. Medwin, J. Acoust. Soc. Am. 58 (1975): 10 deg C, 35 ppt, surface and 100 m.
  const Ocean ocean({}, origin);
  EXPECT_NEAR(ocean.sound_speed_mps(0), 1489.99, 1e-9);
  EXPECT_NEAR(ocean.sound_speed_mps(100), 1491.59, 1e-9);
}

}  // namespace ocean_test
}  // namespace drydock::ocean
