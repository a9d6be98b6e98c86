#include <fmt/format.h>
#include <gmock/gmock.h>

#include <set>

#include "tests/hil/emulate/ublox_host.hpp"

/// The epochs of an emulated u-blox: their times, their messages and what these hold.
namespace drydock::emulate {
namespace ublox_epochs_test {

using rig_config::UbloxModel;
using testing::IsEmpty;
namespace ubx = wire::ubx;

TEST(EmulatedUblox, SendsAnEpochAtEachWholeMultipleOfTheNewPeriod) {
  UbloxHost host(UbloxModel::m8);
  host.listen(0.5);
  EXPECT_TRUE(host.acknowledges(ubx::cfg_rate, {200, 0, 1, 0, 0, 0}));
  host.listen(2);
  const auto epochs = host.all<wire::NavPvt>();
  ASSERT_EQ(epochs.size(), 10u);
  EXPECT_EQ(epochs[0].itow, std::chrono::milliseconds{252'818'600});
  EXPECT_EQ(epochs[9].itow, std::chrono::milliseconds{252'820'400});
}

TEST(EmulatedUblox, AnEpochIsNotSentAgainWhenItsInstantSetsAnotherPeriod) {
  UbloxHost host(UbloxModel::m8);
  host.listen(1);
  EXPECT_EQ(host.all<wire::NavPvt>().size(), 2u);
  EXPECT_TRUE(host.acknowledges(ubx::cfg_rate, {200, 0, 1, 0, 0, 0}));
  host.listen(0.3);
  ASSERT_EQ(host.all<wire::NavPvt>().size(), 1u);
  EXPECT_EQ(host.all<wire::NavPvt>()[0].itow, std::chrono::milliseconds{252'819'200});
}

TEST(EmulatedUblox, SendsEachMessageAtItsOwnRateOfEpochs) {
  UbloxHost host(UbloxModel::m8, 5);
  EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, {0x01, 0x20, 5}));
  EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, {0x01, 0x04, 2}));
  EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, {0x0A, 0x09, 5}));
  EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, {0x01, 0x61, 0}));
  EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, {0x0D, 0x03, 1}));
  host.listen(1.99);
  EXPECT_EQ(host.count(0x0107), 10u);
  EXPECT_EQ(host.count(0x0120), 2u);
  EXPECT_EQ(host.count(0x0104), 5u);
  EXPECT_EQ(host.count(0x0A09), 2u);
  EXPECT_EQ(host.count(0x0161), 0u);
  EXPECT_EQ(host.count(0x0D03), 0u) << "a time mark needs an edge";
}

TEST(EmulatedUblox, ThePartsOfAnEpochHoldTheTruthWithinTheirDigits) {
  UbloxHost host(UbloxModel::m8);
  for (const std::uint8_t id : {0x02, 0x03, 0x04, 0x06, 0x12, 0x20, 0x30})
    EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, {0x01, id, 1}));
  host.listen(0.5);
  const auto posllh = host.all<wire::NavPosllh>().at(0);
  EXPECT_NEAR(*posllh.latitude_rad, 47.123456 * degree, 1e-7 * degree);
  EXPECT_NEAR(*posllh.longitude_rad, -8.765432 * degree, 1e-7 * degree);
  EXPECT_NEAR(*posllh.ellipsoidal_height_m, -0.1, 1e-3);
  const Eigen::Vector3d v = at_the_surface().velocity_ned;
  const auto velned = host.all<wire::NavVelned>().at(0);
  EXPECT_NEAR(*velned.velocity_north_mps, v.x(), 0.005);
  EXPECT_NEAR(*velned.velocity_east_mps, v.y(), 0.005);
  EXPECT_NEAR(*velned.velocity_down_mps, v.z(), 0.005);
  EXPECT_NEAR(*velned.speed_mps, v.norm(), 0.005);
  // 2023-11-14 22:13:20 UTC is in GPS week 2288; 18 leap seconds.
  const auto time = host.all<wire::NavTimeGps>().at(0);
  EXPECT_EQ(time.gps_week, 2288);
  EXPECT_EQ(time.leap_seconds, 18);
  EXPECT_EQ(time.itow, std::chrono::seconds{252'818});
  const auto status = host.all<wire::NavStatus>().at(0);
  EXPECT_TRUE(status.fix_ok && status.week_known && status.time_known);
  EXPECT_LT(*host.all<wire::NavDop>().at(0).horizontal, *host.all<wire::NavDop>().at(0).position);
  // WGS-84 at 47.123456 N, 8.765432 W, -0.1 m: computed with a = 6378137 m, 1/f = 298.257223563.
  const auto ecef = host.all<wire::NavSol>().at(0).position_ecef_m;
  EXPECT_NEAR(*ecef[0], 4'296'861.589, 0.02);
  EXPECT_NEAR(*ecef[1], -662'535.032, 0.02);
  EXPECT_NEAR(*ecef[2], 4'651'114.223, 0.02);
  EXPECT_EQ(host.all<wire::NavSol>().at(0).gps_week, 2288);
  EXPECT_EQ(host.all<wire::NavSvinfo>().at(0).satellites.size(), 10u);
}

// UBX-18010854: the six fields are rounded to a hundredth, nano lies from -5 000 000 to 994 999
// 999.
TEST(EmulatedUblox, TheFieldsOfUtcAreThoseOfTheSentencesOfTheEpoch) {
  UbloxHost host(UbloxModel::f9, 10);
  ASSERT_TRUE(host.acknowledges(wire::ubx::cfg_msg, {0xF0, 0x04, 1}));
  host.listen(2);
  std::set<int> fractions;
  std::string rmc_time;
  for (const auto& frame : host.heard) {
    if (frame[0] == '$') rmc_time = std::string(frame.begin() + 7, frame.begin() + 16);
    if (frame[0] == '$' || wire::ubx::packet_of(frame).class_and_id != 0x0107) continue;
    const auto pvt = wire::ubx::packet_of(frame).payload;
    const auto nano = wire::load_le<std::int32_t>(pvt, 16);
    EXPECT_EQ(rmc_time,
              fmt::format("{:02}{:02}{:02}.{:02}", pvt[8], pvt[9], pvt[10], nano / 10'000'000));
    fractions.insert(nano / 100'000'000);
  }
  EXPECT_EQ(fractions.size(), 10u);
}

// sAcc / gSpeed in radians, at most 180 degrees.
TEST(EmulatedUblox, TheAccuracyOfTheCourseIsThatOfTheSpeedAcrossTheWay) {
  UbloxHost host(UbloxModel::m8);
  host.listen(1.5);
  const auto pvt = host.all<wire::NavPvt>().at(0);
  ASSERT_TRUE(pvt.course_accuracy_rad);
  EXPECT_NEAR(*pvt.course_accuracy_rad,
              std::min(std::numbers::pi, *pvt.speed_accuracy_mps / *pvt.ground_speed_mps), 2e-7);
}

TEST(EmulatedUblox, APollOfAMessageIsAnsweredAtOnce) {
  UbloxHost host(UbloxModel::m8);
  host.listen(0.1);
  const auto answers = host.say(0x0130);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0][6 + 5], 4) << "globalFlags: an M8";
  EXPECT_THAT(host.say(0x0199), IsEmpty());
}

TEST(EmulatedUblox, WithoutGpsThereIsNoFix) {
  UbloxHost host(UbloxModel::m8);
  EXPECT_TRUE(host.acknowledges(ubx::cfg_gnss, {0, 32, 32, 1, 0, 8, 16, 0, 0, 0, 1, 0}));
  host.listen(0.5);
  EXPECT_FALSE(host.all<wire::NavPvt>().at(0).fix_ok);
  EXPECT_THAT(host.all<wire::NavSat>().at(0).satellites, IsEmpty());
}

TEST(EmulatedUblox, AColdStartTakesThe26SecondsOfTheDataSheet) {
  UbloxHost host(UbloxModel::m8);
  host.listen(1.5);
  EXPECT_THAT(host.say(ubx::cfg_rst, {0xFF, 0xFF, 2, 0}), IsEmpty()) << "no acknowledgement";
  host.listen(60);
  const auto epochs = host.all<wire::NavPvt>();
  const auto fixed = std::ranges::find(epochs, true, &wire::NavPvt::fix_ok);
  EXPECT_EQ(fixed - epochs.begin(), 26);
}

}  // namespace ublox_epochs_test
}  // namespace drydock::emulate
