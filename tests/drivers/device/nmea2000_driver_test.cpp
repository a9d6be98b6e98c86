#include "tests/drivers/device/support.hpp"

/// Speed log and satellite receiver on NMEA 2000. The frames are of real buses in canboat's
/// samples, or written by hand from the field tables of canboat's public PGN database.
namespace drydock::device::test {
namespace nmea2000_driver_test {

using measurement::FixQuality;
using measurement::FixType;
using measurement::GnssFix;
using measurement::GnssSatellites;
using measurement::WaterSpeed;

struct Bus {
  explicit Bus(Kind kind, double latency_s = 0)
      : Bus([&] {
          DriverOptions o = options(kind, "nmea2000");
          o.latency = from_seconds(latency_s);
          return o;
        }()) {}
  explicit Bus(const DriverOptions& o) : driver(frame_driver(o)) {}

  void says(std::uint32_t id, std::initializer_list<unsigned> data, double at = 1) {
    driver->receive(can_frame(id, true, data), at_s(at), ear);
  }
  /// A fast packet; its frames end a millisecond apart.
  void says_packet(std::uint32_t id, const Octets& message, double at) {
    std::size_t next = 0;
    for (unsigned index = 0; next < message.size() || index == 0; ++index) {
      Octets data{std::uint8_t(2U << 5 | index)};
      if (index == 0) data.push_back(static_cast<std::uint8_t>(message.size()));
      while (data.size() < 8) data.push_back(next < message.size() ? message[next++] : 0xFF);
      wire::CanFrame frame = can_frame(id, true, {});
      frame.size = 8;
      std::copy(data.begin(), data.end(), frame.data.begin());
      driver->receive(frame, at_s(at + 1e-3 * index), ear);
    }
  }
  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

constexpr std::uint32_t speed_id = 0x09F50323, distance_id = 0x19F51323;

TEST(Nmea2000Log, TheSpeedOfARealPaddleWheelHasNoSign) {
  Bus bus(Kind::emlog);
  bus.says(speed_id, {0xFF, 0x1B, 0x01, 0xFF, 0xFF, 0x00, 0xFF, 0xFF});
  const auto speeds = bus.ear.all<WaterSpeed>();
  ASSERT_EQ(speeds.size(), 1U);
  EXPECT_DOUBLE_EQ(speeds[0].longitudinal_mps.value(), 2.83);
  EXPECT_FALSE(speeds[0].transverse_mps || speeds[0].distance_m || speeds[0].sigma_mps);
}

TEST(Nmea2000Log, DirectionOneIsAstern) {
  Bus bus(Kind::emlog);
  bus.says(speed_id, {0, 0x1B, 0x01, 0xFF, 0xFF, 4, 0xF1, 0xFF});
  bus.says(speed_id, {1, 0x1B, 0x01, 0xFF, 0xFF, 4, 0xF0, 0xFF});
  const auto speeds = bus.ear.all<WaterSpeed>();
  EXPECT_DOUBLE_EQ(speeds.at(0).longitudinal_mps.value(), -2.83);
  EXPECT_DOUBLE_EQ(speeds.at(1).longitudinal_mps.value(), 2.83);
}

TEST(Nmea2000Log, TheGroundSpeedNeverComesOutAndAMissingSpeedIsNoNumber) {
  Bus bus(Kind::emlog);
  bus.says(speed_id, {0, 0xFF, 0xFF, 0x1B, 0x01, 4, 0xF0, 0xFF});
  const auto speeds = bus.ear.all<WaterSpeed>();
  ASSERT_EQ(speeds.size(), 1U);
  EXPECT_FALSE(speeds[0].longitudinal_mps);
}

TEST(Nmea2000Log, ASpeedThatNoLogMeasuresIsRefused) {
  Bus bus(Kind::emlog);
  bus.says(speed_id, {0, 0x88, 0x13, 0xFF, 0xFF, 4, 0xF0, 0xFF});  // 50.00 m/s
  bus.says(speed_id, {1, 0x89, 0x13, 0xFF, 0xFF, 4, 0xF0, 0xFF});  // 50.01 m/s
  EXPECT_EQ(bus.ear.all<WaterSpeed>().size(), 1U);
  EXPECT_EQ(bus.ear.refusals.size(), 1U);
}

TEST(Nmea2000Log, TheDistanceIsTheTotalInMetres) {
  Bus bus(Kind::emlog);
  Octets log(14, 0xFF);
  put(log, 6, 4, 4711);
  put(log, 10, 4, 12);
  bus.says_packet(distance_id, log, 1);
  ASSERT_EQ(bus.ear.heard.size(), 1U);
  EXPECT_DOUBLE_EQ(bus.ear.all<WaterSpeed>().at(0).distance_m.value(), 4711);
}

TEST(Nmea2000Log, TwoLogsOfOneBusAreNeverMixed) {
  Bus bus(Kind::emlog);
  for (double t = 1; t < 5; ++t) {
    bus.says(speed_id, {0, 100, 0, 0xFF, 0xFF, 4, 0xF0, 0xFF}, t);
    bus.says(speed_id + 1, {0, 200, 0, 0xFF, 0xFF, 4, 0xF0, 0xFF}, t + 0.5);
  }
  for (const auto& speed : bus.ear.all<WaterSpeed>()) EXPECT_DOUBLE_EQ(*speed.longitudinal_mps, 1);
  EXPECT_EQ(bus.ear.heard.size(), 4U);
}

TEST(Nmea2000Log, SpeedsAreOlderThanTheirFrameByTheLatency) {
  Bus bus(Kind::emlog, 0.25);
  bus.says(speed_id, {0xFF, 0x1B, 0x01, 0xFF, 0xFF, 0x00, 0xFF, 0xFF}, 1);
  const auto speed = bus.ear.all<WaterSpeed>().at(0);
  // 29-bit identifier, 8 bytes: 131 bits and up to 29 stuff bits at 250 kbit/s.
  EXPECT_GT(speed.origin.valid_at, at_s(0.75 - 160 / 250e3));
  EXPECT_LE(speed.origin.valid_at, at_s(0.75 - 131 / 250e3));
}

constexpr std::uint32_t position_id = 0x0DF80526, rapid_id = 0x09F80126, course_id = 0x09F80226,
                        dilutions_id = 0x19FA0326, satellites_id = 0x19FA0426;

/// PGN 129029: 42.5 N, 71.25 W, 12.5 m above the ellipsoid, geoid 33.63 m below it.
Octets position(unsigned sequence, unsigned method, std::int64_t days = 20779) {
  Octets m(43, 0xFF);
  m[0] = static_cast<std::uint8_t>(sequence);
  put(m, 1, 2, days);
  put(m, 3, 4, 123456789);  // 12345.6789 s
  put(m, 7, 8, 425'000'000'000'000'000);
  put(m, 15, 8, -712'500'000'000'000'000);
  put(m, 23, 8, 12'500'000);
  m[31] = static_cast<std::uint8_t>(method << 4);
  m[33] = 9;
  put(m, 34, 2, 90);
  put(m, 36, 2, 140);
  put(m, 38, 4, -3363);
  return m;
}

TEST(Nmea2000Gnss, OneFixOfAllMessagesWithOneSid) {
  Bus bus(Kind::gnss);
  // True course 4.9141 rad, 3.19 m/s: the frame of a real receiver, with SID 7.
  bus.says(course_id, {7, 0xFC, 0xF5, 0xBF, 0x3F, 0x01, 0xFF, 0xFF}, 1);
  bus.says_packet(position_id, position(7, 1), 1.01);
  EXPECT_TRUE(bus.ear.heard.empty()) << "more of this instant may come";
  bus.driver->tick(at_s(1.2), bus.ear);
  const auto fixes = bus.ear.all<GnssFix>();
  ASSERT_EQ(fixes.size(), 1U);
  const GnssFix& fix = fixes[0];
  EXPECT_EQ(fix.type, FixType::three_d);
  EXPECT_EQ(fix.quality, FixQuality::autonomous);
  EXPECT_NEAR(fix.position.value().latitude_rad, 42.5 * degree, 1e-12);
  EXPECT_NEAR(fix.position.value().longitude_rad, -71.25 * degree, 1e-12);
  EXPECT_DOUBLE_EQ(fix.ellipsoidal_height_m.value(), 12.5);
  EXPECT_NEAR(fix.mean_sea_level_height_m.value(), 12.5 + 33.63, 1e-9);
  EXPECT_DOUBLE_EQ(fix.position_dop.value(), 1.4);
  EXPECT_EQ(fix.satellites_used, 9);
  EXPECT_DOUBLE_EQ(fix.ground_speed_mps.value(), 3.19);
  EXPECT_DOUBLE_EQ(fix.course_rad.value(), 4.9141);
  // 2026-11-22 is day 20779 of 1970: date -u -d @$((20779 * 86400)).
  using namespace std::chrono;
  EXPECT_EQ(fix.utc.value(),
            Stamp{sys_days{2026y / 11 / 22}.time_since_epoch()} + 12345s + 678900us);
  EXPECT_LT(fix.origin.valid_at, at_s(1)) << "as old as its first frame";
}

TEST(Nmea2000Gnss, ANewSidEndsAnEpochAndItsCourseIsNotThatOfTheNext) {
  Bus bus(Kind::gnss);
  bus.says_packet(position_id, position(7, 1), 1);
  bus.says(course_id, {8, 0xFC, 0xF5, 0xBF, 0x3F, 0x01, 0xFF, 0xFF}, 1.05);
  const auto fixes = bus.ear.all<GnssFix>();
  ASSERT_EQ(fixes.size(), 1U);
  EXPECT_FALSE(fixes[0].ground_speed_mps || fixes[0].course_rad);
}

TEST(Nmea2000Gnss, AFastPacketIsAsOldAsItsFirstFrame) {
  Bus bus(Kind::gnss);
  bus.says_packet(position_id, position(7, 1), 1);  // seven frames, 1 ms apart
  bus.driver->finish(bus.ear);
  const auto fix = bus.ear.all<GnssFix>().at(0);
  EXPECT_EQ(fix.origin.received_at, at_s(1.006));
  EXPECT_LT(fix.origin.valid_at, at_s(1));
}

TEST(Nmea2000Gnss, SatellitesWithTheSidOfAnOpenEpochAreAsOldAsIt) {
  Bus bus(Kind::gnss);
  bus.says(course_id, {7, 0xFC, 0xF5, 0xBF, 0x3F, 0x01, 0xFF, 0xFF}, 1);
  Octets sky(3 + 12, 0xFF);
  sky[0] = 7;
  sky[2] = 1;
  bus.says_packet(satellites_id, sky, 1.02);
  sky[0] = 8;
  bus.says_packet(satellites_id, sky, 1.04);
  const auto lists = bus.ear.all<GnssSatellites>();
  EXPECT_LT(lists.at(0).origin.valid_at, at_s(1));
  EXPECT_GT(lists.at(1).origin.valid_at, at_s(1.03));
}

TEST(Nmea2000Log, ADistanceBehindASpeedWasTrueWhenTheSpeedWas) {
  Bus bus(Kind::emlog);
  // A frame of 29 bits and 8 bytes takes 0.52 to 0.64 ms; here they end 0.6 ms apart.
  bus.says(speed_id, {0, 0x1B, 0x01, 0xFF, 0xFF, 4, 0xF0, 0xFF}, 1);
  bus.says(distance_id, {0x40, 14, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, 1.0006);
  bus.says(distance_id, {0x41, 0x67, 0x12, 0, 0, 12, 0, 0}, 1.0012);
  bus.says(distance_id, {0x42, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, 1.0018);
  const auto all = bus.ear.all<WaterSpeed>();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_DOUBLE_EQ(all[1].distance_m.value_or(0), 4711);
  EXPECT_EQ(all[1].origin.valid_at, all[0].origin.valid_at);
}

TEST(Nmea2000Gnss, WithoutAFixThereIsNoPosition) {
  for (const unsigned method : {0U, 7U, 8U, 15U}) {  // none, typed in, simulated, not available
    Bus bus(Kind::gnss);
    bus.says_packet(position_id, position(7, method), 1);
    bus.driver->finish(bus.ear);
    const auto fix = bus.ear.all<GnssFix>().at(0);
    EXPECT_EQ(fix.type, FixType::none) << method;
    EXPECT_FALSE(fix.position || fix.ellipsoidal_height_m) << method;
    EXPECT_TRUE(fix.utc) << method;
  }
}

TEST(Nmea2000Gnss, TheMethodSaysTheQuality) {
  const auto quality = [](unsigned method) {
    Bus bus(Kind::gnss);
    bus.says_packet(position_id, position(7, method), 1);
    bus.driver->finish(bus.ear);
    return bus.ear.all<GnssFix>().at(0).quality;
  };
  EXPECT_EQ(quality(2), FixQuality::differential);
  EXPECT_EQ(quality(4), FixQuality::rtk_fixed);
  EXPECT_EQ(quality(5), FixQuality::rtk_float);
  EXPECT_EQ(quality(6), FixQuality::dead_reckoning);
}

TEST(Nmea2000Gnss, TheRapidPositionIsAFixOnlyWithoutTheCompleteOne) {
  Bus bus(Kind::gnss);
  // A real frame: 34.4059417 N, 133.5412196 E.
  const std::initializer_list<unsigned> rapid{0x19, 0xEE, 0x81, 0x14, 0xE4, 0xC5, 0x98, 0x4F};
  bus.says(rapid_id, rapid, 1);
  const auto fixes = bus.ear.all<GnssFix>();
  ASSERT_EQ(fixes.size(), 1U);
  EXPECT_EQ(fixes[0].type, FixType::two_d);
  EXPECT_NEAR(fixes[0].position.value().latitude_rad, 34.4059417 * degree, 1e-12);
  EXPECT_NEAR(fixes[0].position.value().longitude_rad, 133.5412196 * degree, 1e-12);

  bus.says_packet(position_id, position(7, 1), 2);
  bus.says(rapid_id, rapid, 2.5);
  EXPECT_EQ(bus.ear.all<GnssFix>().size(), 2U);
  bus.says(rapid_id, rapid, 9);
  EXPECT_EQ(bus.ear.all<GnssFix>().size(), 3U);
}

TEST(Nmea2000Gnss, ACourseFromMagneticNorthIsNone) {
  Bus bus(Kind::gnss);
  bus.says(course_id, {7, 0xFD, 0xF5, 0xBF, 0x3F, 0x01, 0xFF, 0xFF}, 1);
  bus.says_packet(position_id, position(7, 1), 1.01);
  bus.driver->finish(bus.ear);
  const auto fix = bus.ear.all<GnssFix>().at(0);
  EXPECT_FALSE(fix.course_rad);
  EXPECT_DOUBLE_EQ(fix.ground_speed_mps.value(), 3.19);
}

TEST(Nmea2000Gnss, WithoutADilutionOfPositionItFollowsFromTheOthers) {
  Bus bus(Kind::gnss);
  Octets fix = position(7, 1);
  put(fix, 36, 2, 0x7FFF);
  bus.says_packet(position_id, fix, 1);
  bus.says(dilutions_id, {7, 0xD3, 90, 0, 120, 0, 0xFF, 0x7F}, 1.01);  // 0.9 and 1.2
  bus.driver->finish(bus.ear);
  EXPECT_NEAR(bus.ear.all<GnssFix>().at(0).position_dop.value(), 1.5, 1e-12);
}

TEST(Nmea2000Gnss, SatellitesHaveTheirConstellations) {
  Bus bus(Kind::gnss);
  Octets sky(3 + 3 * 12, 0xFF);
  sky[2] = 3;
  const auto seen = [&](std::size_t i, unsigned number, unsigned status) {
    sky[3 + 12 * i] = static_cast<std::uint8_t>(number);
    put(sky, 4 + 12 * i, 2, 5000);
    put(sky, 8 + 12 * i, 2, 4150);
    sky[14 + 12 * i] = static_cast<std::uint8_t>(0xF0 | status);
  };
  seen(0, 17, 2);
  seen(1, 33, 1);  // SBAS 120
  seen(2, 71, 5);  // GLONASS 7
  bus.says_packet(satellites_id, sky, 1);
  const auto lists = bus.ear.all<GnssSatellites>();
  ASSERT_EQ(lists.size(), 1U);
  ASSERT_EQ(lists[0].satellites.size(), 3U);
  using enum measurement::Constellation;
  const auto& s = lists[0].satellites;
  EXPECT_TRUE(s[0].constellation == gps && s[0].number == 17 && s[0].used);
  EXPECT_TRUE(s[1].constellation == sbas && s[1].number == 120 && !s[1].used);
  EXPECT_TRUE(s[2].constellation == glonass && s[2].number == 7 && s[2].used);
  EXPECT_DOUBLE_EQ(s[0].cno_dbhz.value(), 41.5);
  EXPECT_DOUBLE_EQ(s[0].elevation_rad.value(), 0.5);
  EXPECT_FALSE(s[0].azimuth_rad);
}

}  // namespace nmea2000_driver_test
}  // namespace drydock::device::test
