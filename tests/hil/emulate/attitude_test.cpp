// Emulated compasses: what they send, and what drivers make of it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drivers/wire/bytes.hpp"
#include "tests/hil/emulate/through_drivers.hpp"

namespace drydock::emulate {
namespace attitude_test {

using measurement::AttitudeSample;
using rig_config::DeviceKind;
using wire::load_le;

TEST(EmulatedCompass, SaysTheTruthInTheLayoutsOfItsThreeMessages) {
  const Frozen trajectory(under_way());  // roll 3, pitch -4, yaw -70 degrees; rate 0.01 -0.02 0.03
  const auto sent = record(device(DeviceKind::attitude, "nmea2000", 10), trajectory, 0.35);
  ASSERT_EQ(sent.frames.size(), 4U);  // address claim and one sample
  EXPECT_EQ(sent.frames[0].frame.id, 0x18EEFF27U);
  EXPECT_EQ(sent.frames[1].frame.id, 0x0DF11927U);
  const auto tilt = sent.frames[1].frame.payload();
  EXPECT_EQ(load_le<std::int16_t>(tilt, 3), -698);  // -4 degrees in 0.1 mrad
  EXPECT_EQ(load_le<std::int16_t>(tilt, 5), 524);   // 3 degrees
  EXPECT_EQ(sent.frames[2].frame.id, 0x09F11227U);
  const auto heading = sent.frames[2].frame.payload();
  EXPECT_EQ(load_le<std::uint16_t>(heading, 1), 50615);  // 290 degrees
  EXPECT_EQ(heading[7] & 3, 0);                          // true north
  EXPECT_EQ(sent.frames[3].frame.id, 0x09F11327U);
  // (q sin roll + r cos roll) / cos pitch in 1/32 urad/s
  const double turn =
      (-0.02 * std::sin(3 * degree) + 0.03 * std::cos(3 * degree)) / std::cos(4 * degree) * 32e6;
  EXPECT_NEAR(load_le<std::int32_t>(sent.frames[3].frame.payload(), 1), turn, 0.51);
}

double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

class Compasses : public ThroughDrivers {
 protected:
  /// The number of headings; each value equals the truth at its valid_at.
  int compare(double heading_limit, double tilt_limit) {
    int headings = 0;
    for (const auto& sample : all<AttitudeSample>()) {
      const auto truth = trajectory_.at(sample.origin.valid_at);
      if (sample.true_heading_rad) {
        ++headings;
        EXPECT_LT(apart(*sample.true_heading_rad, truth.yaw_rad), heading_limit);
      }
      if (sample.roll_rad) {
        EXPECT_NEAR(*sample.roll_rad, truth.roll_rad, tilt_limit);
        EXPECT_NEAR(*sample.pitch_rad, truth.pitch_rad, tilt_limit);
      }
    }
    return headings;
  }
};

TEST_F(Compasses, HeadingAndTiltOfABusComeBack) {
  run_bus(device::Kind::attitude, device(DeviceKind::attitude, "nmea2000", 10));
  EXPECT_GT(compare(1.5e-4, 1.5e-4), 880);
}

TEST_F(Compasses, AMountingInAnyDirectionComesBackAsTheAttitudeOfTheBody) {
  auto config = device(DeviceKind::attitude, "nmea2000", 10);
  config.mounting_rad = {20 * degree, -30 * degree, 130 * degree};
  run_bus(device::Kind::attitude, config);
  EXPECT_GT(compare(4e-4, 3e-4), 880);  // three rounded angles of 0.1 mrad each enter
}

TEST_F(Compasses, HeadingOfALineComesBackOncePerSample) {
  run_line(device::Kind::attitude, device(DeviceKind::attitude, "nmea0183", 10), 38400);
  const int headings = compare(2e-4, 0);  // two decimals of a degree
  EXPECT_GT(headings, 880);
  EXPECT_LT(headings, 905);
}

rig_config::DeviceConfig magnetic(const char* protocol) {
  auto config = device(DeviceKind::attitude, protocol, 10);
  config.emulate.compass = {.variation_rad = -8.5 * degree, .magnetic = true};
  return config;
}

// A true heading of 290 degrees shows as 290 + 2 + 3 sin 290 - 1 cos 290 = 288.84.
TEST(EmulatedCompass, HasTheErrorThatTheRigKnows) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::attitude, "nmea2000", 10);
  config.compass_error_rad = {2 * degree, 3 * degree, -1 * degree};
  const auto sent = record(config, trajectory, 0.35);
  EXPECT_NEAR(load_le<std::uint16_t>(sent.frames.at(2).frame.payload(), 1), 288.8389 * degree * 1e4,
              0.6);
}

TEST_F(Compasses, AnErrorThatTheRigKnowsIsTakenOffAgain) {
  auto config = magnetic("nmea2000");
  config.compass_error_rad = {2 * degree, 3 * degree, -1 * degree};
  run_bus(device::Kind::attitude, config);
  EXPECT_GT(compare(2.5e-4, 1.5e-4), 880);
}

// The vehicle points to 290 degrees: 298.5 from a north that stands 8.5 degrees to the west.
TEST(EmulatedCompass, PointsToMagneticNorthIfTheRigSaysSo) {
  const Frozen trajectory(under_way());
  const auto sent = record(magnetic("nmea2000"), trajectory, 0.35);
  const auto heading = sent.frames.at(2).frame.payload();
  EXPECT_EQ(load_le<std::uint16_t>(heading, 1), 52098);  // 298.5 degrees in 0.1 mrad
  EXPECT_EQ(load_le<std::int16_t>(heading, 5), -1484);   // -8.5 degrees
  EXPECT_EQ(heading[7] & 3, 1);                          // magnetic north
  const auto bytes = record(magnetic("nmea0183"), trajectory, 0.05).all_bytes();
  EXPECT_TRUE(std::string(bytes.begin(), bytes.end())
                  .starts_with("$HCHDG,298.50,,,8.50,W*30\r\n$HCHDM,298.50,M*"));
}

TEST_F(Compasses, AMagneticHeadingComesBackAsTheTrueOne) {
  run_bus(device::Kind::attitude, magnetic("nmea2000"));
  EXPECT_GT(compare(2.5e-4, 1.5e-4), 880);  // heading and variation are both rounded
}

TEST_F(Compasses, AMagneticHeadingOfALineComesBackAsTheTrueOneOncePerSample) {
  run_line(device::Kind::attitude, magnetic("nmea0183"), 38400);
  const int headings = compare(2e-4, 0);
  EXPECT_GT(headings, 880);
  EXPECT_LT(headings, 905);
}

}  // namespace attitude_test
}  // namespace drydock::emulate
