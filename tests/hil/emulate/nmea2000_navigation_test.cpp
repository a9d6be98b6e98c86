// The speed log and the satellite receiver on NMEA 2000: what they send, and what drivers make of
// it.
#include <gtest/gtest.h>

#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "tests/hil/emulate/through_drivers.hpp"

namespace drydock::emulate {
namespace nmea2000_navigation_test {

using rig_config::DeviceKind;
using wire::load_le;

/// The content of a PGN's fast packets, or of its frames, from the layouts of canboat's database.
std::vector<std::vector<std::uint8_t>> content_of(const Recorder& sent, std::uint32_t pgn,
                                                  bool fast) {
  std::vector<std::vector<std::uint8_t>> all;
  for (const auto& f : sent.frames) {
    const auto data = f.frame.payload();
    if ((f.frame.id >> 8 & 0x3FFFF) != pgn) continue;
    if (!fast || (data[0] & 0x1F) == 0) all.emplace_back();
    all.back().insert(all.back().end(), data.begin() + (fast ? (data[0] & 0x1F) == 0 ? 2 : 1 : 0),
                      data.end());
  }
  return all;
}

TEST(EmulatedLog, SpeedThroughTheWaterWithSensorAndDirection) {
  motion::Truth truth = under_way();
  const Frozen trajectory(truth);
  const auto sent = record(device(DeviceKind::emlog, "nmea2000", 10), trajectory, 1);
  EXPECT_EQ(sent.frames.at(0).frame.id, 0x18EEFF25U);
  const auto speed = content_of(sent, 128259, false).at(0);
  EXPECT_NEAR(load_le<std::uint16_t>(speed, 1) * 0.01, std::abs(truth.velocity_body.x()), 0.0051);
  EXPECT_EQ(load_le<std::uint16_t>(speed, 3), 0xFFFF);  // no speed over ground
  EXPECT_EQ(speed[5], 4);                               // electromagnetic
  EXPECT_EQ(speed[6], 0xF0);                            // forward
  EXPECT_EQ(content_of(sent, 128275, true).size(), 1U);
}

TEST(EmulatedReceiver, SaysTheTruthInTheLayoutsOfItsFiveMessages) {
  const Frozen trajectory(at_the_surface());
  const auto sent = record(device(DeviceKind::gnss, "nmea2000"), trajectory, 1.5);
  const auto position = content_of(sent, 129029, true).at(0);
  EXPECT_EQ(load_le<std::uint16_t>(position, 1), 19675);  // 2023-11-14
  EXPECT_EQ(position[31] >> 4, 1);                        // a fix
  EXPECT_NEAR(load_le<std::int64_t>(position, 7) * 1e-16, 47.123456, 1e-9);
  EXPECT_NEAR(load_le<std::int64_t>(position, 15) * 1e-16, -8.765432, 1e-9);
  EXPECT_NEAR(load_le<std::int64_t>(position, 23) * 1e-6, -0.1, 1e-6);
  const auto rapid = content_of(sent, 129025, false).at(0);
  EXPECT_NEAR(load_le<std::int32_t>(rapid, 0) * 1e-7, 47.123456, 1e-7);
  const auto course = content_of(sent, 129026, false).at(0);
  const Eigen::Vector3d v = at_the_surface().velocity_ned;
  EXPECT_NEAR(load_le<std::uint16_t>(course, 4) * 0.01, std::hypot(v.x(), v.y()), 0.0051);
  EXPECT_EQ(course[1] & 3, 0);  // true north
  EXPECT_EQ(course[0], position[0]);
  const auto sky = content_of(sent, 129540, true).at(0);
  EXPECT_EQ(sky[2], 10);  // satellites
  EXPECT_EQ(content_of(sent, 129539, false).size(), content_of(sent, 129026, false).size());
}

TEST_F(ThroughDrivers, TheLogOfABusGivesTheSpeedThroughTheWater) {
  run_bus(device::Kind::emlog, device(DeviceKind::emlog, "nmea2000", 10));
  double travelled = 0;
  int speeds = 0;
  for (const auto& sample : all<measurement::WaterSpeed>()) {
    if (sample.distance_m) travelled = *sample.distance_m;
    if (!sample.longitudinal_mps) continue;
    ++speeds;
    const auto truth = trajectory_.at(sample.origin.valid_at);
    ASSERT_NEAR(*sample.longitudinal_mps, truth.velocity_body.x(), 0.006);
  }
  EXPECT_GT(speeds, 880);
  EXPECT_NEAR(travelled, 90 * 2.1, 12);  // between 2 and 2.5 m/s for 30 s, then 2 m/s
}

TEST_F(ThroughDrivers, TheReceiverOfABusGivesThePositionAtItsTimeOfValidity) {
  run_bus(device::Kind::gnss, device(DeviceKind::gnss, "nmea2000", 5));
  int positions = 0;
  for (const auto& fix : all<measurement::GnssFix>()) {
    if (!fix.position) continue;
    ++positions;
    const auto truth = trajectory_.at(fix.origin.valid_at);
    // At 2.5 m/s the frame's time of 0.6 ms is 1.5 mm.
    ASSERT_NEAR(fix.position->latitude_rad * 6.4e6, truth.latitude_rad * 6.4e6, 0.02);
    ASSERT_NEAR(fix.position->longitude_rad * 6.4e6, truth.longitude_rad * 6.4e6, 0.02);
    ASSERT_TRUE(fix.ground_speed_mps && fix.course_rad && fix.utc);
    EXPECT_NEAR(*fix.ground_speed_mps, truth.velocity_ned.head<2>().norm(), 0.006);
    EXPECT_LT(std::abs(std::chrono::duration<double>(*fix.utc - fix.origin.valid_at).count()),
              2e-3);
  }
  EXPECT_GT(positions, 100) << "before the dive";
  EXPECT_GT(all<measurement::GnssSatellites>().size(), 400U);
}

}  // namespace nmea2000_navigation_test
}  // namespace drydock::emulate
