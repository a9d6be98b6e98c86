#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hil/sky/antenna.hpp"
#include "hil/sky/broadcast_sky.hpp"
#include "hil/sky/ephemeris_file.hpp"
#include "hil/sky/look.hpp"
#include "tests/hil/sky/files.hpp"

namespace drydock::sky {
namespace receiver_test {

using Eigen::Vector3d;
constexpr double degree = M_PI / 180;

double decibels(double power) { return 10 * std::log10(power); }

TEST(Antenna, ThePatternIsThatOfTheRollPaperCorrected) {
  EXPECT_DOUBLE_EQ(antenna_power(90 * degree), 1);
  EXPECT_NEAR(decibels(antenna_power(0)), -8.4, 0.05);
  // The paper's 64.58 deg off boresight: lower by a factor of e.
  EXPECT_NEAR(antenna_power((90 - 64.58) * degree), std::exp(-1), 1e-12);
  EXPECT_NEAR(664 * antenna_power(-90 * degree), 664 * std::exp(-std::pow(180 / 64.58, 2)), 1e-9);
}

TEST(Antenna, ElevationIsCountedFromItsOwnHorizon) {
  const Vector3d up{0, 0, -1}, down{0, 0, 1}, ahead{1, 0, 0};
  EXPECT_NEAR(antenna_elevation(down, down), 90 * degree, 1e-12);
  EXPECT_NEAR(antenna_elevation(ahead, down), 0, 1e-12);
  EXPECT_NEAR(antenna_elevation(up, down), -90 * degree, 1e-12);
  // Eq. (24) of the paper: atan(p_z / |p_xy|) with the antenna on +z.
  const Vector3d p = Vector3d{2, -1, 0.7}.normalized();
  EXPECT_NEAR(antenna_elevation(p, down), std::atan2(p.z(), std::hypot(p.x(), p.y())), 1e-12);
}

const measurement::Stamp bench = utc_time(test::walker_toe);

motion::Truth standing_at(double latitude_deg, double longitude_deg) {
  motion::Truth truth;
  truth.at = bench;
  truth.latitude_rad = latitude_deg * degree;
  truth.longitude_rad = longitude_deg * degree;
  return truth;
}

BroadcastOrbits walker_orbits() {
  return BroadcastOrbits(read_navigation_file(test::walker()).value().records);
}

BroadcastSky sky_of(const rig_config::SkyConfig& config, std::uint64_t seed = 1) {
  return BroadcastSky(walker_orbits(), config, bench, seed, "gnss");
}

TEST(BroadcastSky, ShowsWhatStandsAboveTheMaskWithDirectionsOfTheOrbits) {
  const auto truth = standing_at(36, 129);
  const BroadcastOrbits orbits = walker_orbits();
  std::vector<int> expected, seen;
  for (int prn = 1; prn <= 24; ++prn) {
    const Look look = look_at(*orbits.nearest(prn, test::walker_toe), test::walker_toe,
                              {truth.latitude_rad, truth.longitude_rad, 0});
    if (look.elevation_rad >= 5 * degree) expected.push_back(prn);
  }
  auto sky = sky_of({});
  for (const auto& satellite : sky.at(truth).satellites) {
    seen.push_back(satellite.number);
    const Look look = look_at(*orbits.nearest(satellite.number, test::walker_toe), test::walker_toe,
                              {truth.latitude_rad, truth.longitude_rad, 0});
    EXPECT_EQ(satellite.elevation_rad, look.elevation_rad);
    EXPECT_EQ(satellite.azimuth_rad, look.azimuth_rad);
  }
  EXPECT_EQ(seen, expected);
  EXPECT_GE(seen.size(), 6);
}

TEST(BroadcastSky, SignalFollowsTheAttitudeByTheAntennasPattern) {
  auto truth = standing_at(36, 129);
  rig_config::SkyConfig config;
  config.antenna_axis = {0, 0, 1};
  config.lowest_cno_dbhz = 0;
  auto sky = sky_of(config);
  const auto first = sky.at(truth).satellites.at(0);
  const double el = *first.elevation_rad, az = *first.azimuth_rad;
  const Vector3d toward{std::cos(el) * std::cos(az), std::cos(el) * std::sin(az), -std::sin(el)};
  const auto cno_when_boresight_is = [&](const Vector3d& ned) {
    truth.body_to_ned = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), ned);
    return *sky.at(truth).satellites.at(0).cno_dbhz;
  };
  EXPECT_EQ(cno_when_boresight_is(toward), 48);
  EXPECT_EQ(cno_when_boresight_is(toward.unitOrthogonal()), 40);  // 48 - 8.43, in whole dB
  EXPECT_EQ(cno_when_boresight_is(-toward), 14);                  // 48 - 33.74
}

TEST(BroadcastSky, WhatIsTooWeakIsKnownButNotTracked) {
  auto truth = standing_at(36, 129);
  truth.body_to_ned = Eigen::Quaterniond{0, 1, 0, 0};  // upside down, the antenna points down
  rig_config::SkyConfig config;
  config.lowest_cno_dbhz = 30;
  auto sky = sky_of(config);
  const auto upside_down = sky.at(truth);
  int lost = 0;
  for (const auto& satellite : upside_down.satellites) {
    EXPECT_EQ(satellite.used, satellite.cno_dbhz.has_value());
    if (!satellite.cno_dbhz) {
      ++lost;
    } else {
      EXPECT_GE(*satellite.cno_dbhz, 30);
    }
  }
  EXPECT_GT(lost, 0);
}

TEST(BroadcastSky, NoiseIsAShareOfTheFullPowerAndDependsOnTheSeedAlone) {
  rig_config::SkyConfig config;
  config.power_noise = 0.1;
  const auto truth = standing_at(36, 129);
  auto one = sky_of(config), again = sky_of(config), other = sky_of(config, 2);
  auto quiet = sky_of({});
  const auto& highest = [](const auto& sky) {
    return *std::ranges::max_element(sky.satellites, {},
                                     [](const auto& s) { return *s.elevation_rad; });
  };
  const double clean = antenna_power(*highest(quiet.at(truth)).elevation_rad);
  double sum = 0, squares = 0;
  bool differs = false;
  constexpr int epochs = 4000;
  for (int i = 0; i < epochs; ++i) {
    const auto sky = one.at(truth), same = again.at(truth);
    differs = differs || highest(other.at(truth)).cno_dbhz != highest(sky).cno_dbhz;
    ASSERT_EQ(highest(sky).cno_dbhz, highest(same).cno_dbhz);
    const double power = std::pow(10, (*highest(sky).cno_dbhz - 48) / 10);
    sum += power - clean;
    squares += (power - clean) * (power - clean);
    EXPECT_EQ(*highest(sky).cno_dbhz, std::round(*highest(sky).cno_dbhz));
  }
  EXPECT_TRUE(differs);
  EXPECT_NEAR(sum / epochs, 0, 0.01);
  // Whole dB add about 1 / sqrt(12) dB, 6.6 % of the power.
  EXPECT_NEAR(std::sqrt(squares / epochs), std::hypot(0.1, 0.066 * clean), 0.01);
}

TEST(BroadcastSky, MayBeTheSkyOfAnotherDay) {
  rig_config::SkyConfig config;
  config.at_utc_ns = bench.time_since_epoch().count();
  const auto years_later = bench + std::chrono::hours{24 * 1000};
  BroadcastSky moved(walker_orbits(), config, years_later, 1, "gnss");
  auto truth = standing_at(36, 129);
  const auto then = sky_of({}).at(truth);
  truth.at = years_later;
  const auto now = moved.at(truth);
  ASSERT_EQ(now.satellites.size(), then.satellites.size());
  EXPECT_EQ(now.satellites[0].elevation_rad, then.satellites[0].elevation_rad);
  EXPECT_EQ(now.origin.valid_at, years_later);
}

}  // namespace receiver_test
}  // namespace drydock::sky
