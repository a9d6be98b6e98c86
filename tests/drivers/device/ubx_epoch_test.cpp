#include "tests/drivers/device/gnss_receiver.hpp"

/// Receivers that send an epoch in parts. Each part is written by hand from the u-blox 7 Receiver
/// Description.
namespace drydock::device::test {
namespace ubx_epoch_test {

using measurement::Constellation;
using measurement::FixType;
using measurement::GnssFix;
using namespace std::chrono;

constexpr int fix_ok = 0x0D;  // inside the masks; week and time of week known

/// 46.404648618 N, 117.020462010 W, 232.9577 m: gpsd computes them from these centimetres (the
/// first fix of its log navisys-gr701w).
Octets sol(std::uint32_t itow_ms, int fix_type = 3, int flags = fix_ok) {
  Octets m(52, 0);
  put(m, 0, 4, itow_ms);
  put(m, 8, 2, 2307);
  put(m, 10, 1, fix_type), put(m, 11, 1, flags);
  put(m, 12, 4, -200169112), put(m, 16, 4, -392507405), put(m, 20, 4, 459654666);
  put(m, 24, 4, 2463);
  put(m, 28, 4, 38), put(m, 32, 4, -22), put(m, 36, 4, -2);
  put(m, 40, 4, 105);
  put(m, 44, 2, 326);
  m[47] = 5;
  return ubx(0x01, 0x06, m);
}

Octets status(std::uint32_t itow_ms, int fix_type, int flags = fix_ok) {
  Octets m(16, 0);
  put(m, 0, 4, itow_ms);
  put(m, 4, 1, fix_type), put(m, 5, 1, flags);
  return ubx(0x01, 0x03, m);
}

Octets posllh(std::uint32_t itow_ms) {
  Octets m(28, 0);
  put(m, 0, 4, itow_ms);
  put(m, 4, 4, 85'000'000), put(m, 8, 4, 472'500'000);
  put(m, 12, 4, 450'000), put(m, 16, 4, 402'000);
  put(m, 20, 4, 4'100), put(m, 24, 4, 3'070);
  return ubx(0x01, 0x02, m);
}

Octets velned(std::uint32_t itow_ms) {
  Octets m(36, 0);
  put(m, 0, 4, itow_ms);
  put(m, 4, 4, 150), put(m, 8, 4, -25), put(m, 12, 4, -4);
  put(m, 16, 4, 152), put(m, 20, 4, 152);
  put(m, 24, 4, 35'053'778);
  put(m, 28, 4, 35);
  return ubx(0x01, 0x12, m);
}

Octets dop(std::uint32_t itow_ms) {
  Octets m(18, 0);
  put(m, 0, 4, itow_ms);
  put(m, 6, 2, 187);
  return ubx(0x01, 0x04, m);
}

Octets time_gps(std::uint32_t itow_ms, int valid) {
  Octets m(16, 0);
  put(m, 0, 4, itow_ms), put(m, 4, 4, -123'456);
  put(m, 8, 2, 1916);
  put(m, 10, 1, 17), put(m, 11, 1, valid);
  return ubx(0x01, 0x20, m);
}

/// GPS 17, used at 43 dBHz, in the south-west; GLONASS 1 is in view.
Octets svinfo(std::uint32_t itow_ms) {
  Octets m(8 + 2 * 12, 0);
  put(m, 0, 4, itow_ms);
  m[4] = 2;
  m[9] = 17, m[10] = 0x0D, m[11] = 7, m[12] = 43, m[13] = 52;
  put(m, 14, 2, 225);
  m[21] = 65, m[22] = 0x24, m[23] = 1;
  return ubx(0x01, 0x30, m);
}

/// GPS 5 on L1 (38 dBHz, used) and L2 (41 dBHz); Galileo 11 is in view.
Octets sig(std::uint32_t itow_ms) {
  Octets m(8 + 3 * 16, 0);
  put(m, 0, 4, itow_ms);
  m[5] = 3;
  m[9] = 5, m[14] = 38, put(m, 18, 2, 0x0029);
  m[25] = 5, m[26] = 3, m[30] = 41, put(m, 34, 2, 0x0001);
  m[40] = 2, m[41] = 11;
  return ubx(0x01, 0x43, m);
}

TEST(UbxEpoch, PartsOfOneTimeOfWeekAreOneFix) {
  Receiver r("ubx");
  r.says(sol(1000) + svinfo(1000) + posllh(1000) + velned(1000) + dop(1000), 1);
  EXPECT_TRUE(r.fixes().empty()) << "more may come";
  r.says(sol(2000), 1.01);
  ASSERT_EQ(r.fixes().size(), 1U);
  ASSERT_EQ(r.skies().size(), 1U);
  const GnssFix fix = r.fixes()[0];
  EXPECT_EQ(fix.type, FixType::three_d);
  EXPECT_NEAR(fix.position->latitude_rad, 47.25 * degree, 1e-12);
  EXPECT_NEAR(fix.position->longitude_rad, 8.5 * degree, 1e-12);
  EXPECT_NEAR(fix.ellipsoidal_height_m.value(), 450, 1e-9);
  EXPECT_NEAR(fix.mean_sea_level_height_m.value(), 402, 1e-9);
  EXPECT_NEAR(fix.horizontal_accuracy_m.value(), 4.1, 1e-12);
  EXPECT_NEAR(fix.velocity_ned->x(), 1.5, 1e-12);
  EXPECT_NEAR(fix.velocity_ned->z(), -0.04, 1e-12);
  EXPECT_NEAR(fix.course_rad.value(), 350.53778 * degree, 1e-12);
  EXPECT_NEAR(fix.position_dop.value(), 1.87, 1e-12);
  EXPECT_EQ(fix.satellites_used, 5);
  EXPECT_EQ(fix.origin.device_time, 1s);
  EXPECT_FALSE(fix.utc) << "weeks and GPS time without leap seconds are no UTC";
}

TEST(UbxEpoch, NavSolAloneGivesPositionAndVelocityAsGpsdTurnsThem) {
  Receiver r("ubx");
  r.says(sol(1000) + nav_eoe(1000), 1);
  const GnssFix fix = r.fixes().at(0);
  EXPECT_NEAR(fix.position->latitude_rad / degree, 46.404648618, 1e-9);
  EXPECT_NEAR(fix.position->longitude_rad / degree, -117.020462010, 1e-9);
  EXPECT_NEAR(fix.ellipsoidal_height_m.value(), 232.9577, 1e-3);
  EXPECT_NEAR(fix.velocity_ned->x(), -0.031, 1e-3);
  EXPECT_NEAR(fix.velocity_ned->y(), 0.438, 1e-3);
  EXPECT_NEAR(fix.velocity_ned->z(), -0.002, 1e-3);
  EXPECT_NEAR(fix.course_rad.value() / degree, 94.0052, 1e-3);
  EXPECT_NEAR(fix.speed_accuracy_mps.value(), 1.05, 1e-12);
  EXPECT_FALSE(fix.mean_sea_level_height_m || fix.horizontal_accuracy_m);
}

TEST(UbxEpoch, AnEpochEndsWhenTheLinePausesAndAStragglerIsNoSecondFix) {
  Receiver r("ubx", 9600);
  r.says(sol(1000) + posllh(1000), 1);
  r.driver->tick(r.driver->deadline().value(), r.ear);
  EXPECT_EQ(r.fixes().size(), 1U);
  EXPECT_FALSE(r.driver->deadline());
  r.says(velned(1000), 1.5);
  EXPECT_FALSE(r.driver->deadline());
  r.says(sol(2000) + nav_eoe(2000), 2);
  EXPECT_EQ(r.fixes().size(), 2U);
}

TEST(UbxEpoch, FixBehindOtherPartsIsAsOldAsTheFirstOfThem) {
  Receiver r("ubx", 9600);
  const Octets parts = svinfo(1000) + sol(1000) + velned(1000);
  r.says(parts, 1);
  r.says(nav_eoe(1000), 1.2);
  const measurement::Origin origin = r.fixes().at(0).origin;
  EXPECT_NEAR(measurement::seconds(at_s(1) - origin.valid_at),
              static_cast<double>(parts.size()) * 10 / 9600, 2e-9);
  EXPECT_EQ(origin.received_at, at_s(1));
}

TEST(UbxEpoch, WithoutAReceiverThatVouchesDigitsAreNoPosition) {
  Receiver r("ubx");
  r.says(sol(1000, 0, 0) + posllh(1000) + velned(1000), 1);     // no fix
  r.says(sol(2000, 3, 0x0C) + posllh(2000) + velned(2000), 2);  // outside the receiver's own masks
  r.says(sol(3000, 5) + posllh(3000), 3);                       // time only
  r.says(status(4000, 0, 0) + posllh(4000), 4);
  r.says(posllh(5000) + velned(5000), 5);  // no message says whether there is a fix
  r.driver->tick(at_s(6), r.ear);
  ASSERT_EQ(r.fixes().size(), 5U);
  for (const GnssFix& fix : r.fixes()) EXPECT_FALSE(fix.position || fix.velocity_ned);
  EXPECT_EQ(r.fixes()[1].type, FixType::none);
  EXPECT_EQ(r.fixes()[2].type, FixType::time_only);
  EXPECT_EQ(r.fixes()[4].type, FixType::none);
}

TEST(UbxEpoch, StatusVouchesWhereThereIsNoNavSol) {
  Receiver r("ubx");
  r.says(status(1000, 3) + posllh(1000) + nav_eoe(1000), 1);
  EXPECT_EQ(r.fixes().at(0).type, FixType::three_d);
  EXPECT_TRUE(r.fixes()[0].position);
}

TEST(UbxEpoch, UtcNeedsLeapSecondsThatTheReceiverHasHeard) {
  Receiver r("ubx");
  r.says(sol(116'017'000) + time_gps(116'017'000, 0x03) + nav_eoe(116'017'000), 1);
  r.says(sol(116'018'000) + time_gps(116'018'000, 0x07) + nav_eoe(116'018'000), 2);
  ASSERT_EQ(r.fixes().size(), 2U);
  EXPECT_FALSE(r.fixes()[0].utc);
  // 2016-09-26, GPS 17 s ahead of UTC: gpsd prints the same time, see fixtures/ubx.
  const auto utc = sys_days{2016y / September / 26} + 8h + 13min + 21s - 123'456ns;
  EXPECT_EQ(r.fixes()[1].utc, Stamp{utc.time_since_epoch()});
}

TEST(UbxEpoch, TheNextWeekIsAnotherEpoch) {
  Receiver r("ubx");
  r.says(sol(604'799'000) + sol(0) + sol(1000) + nav_eoe(1000), 1);
  ASSERT_EQ(r.fixes().size(), 3U);
  EXPECT_EQ(r.fixes()[0].origin.device_time, 604'799s);
  EXPECT_EQ(r.fixes()[1].origin.device_time, 0s);
}

TEST(UbxEpoch, NavPvtSaysItBetterThanTheParts) {
  Receiver r("ubx");
  for (std::uint32_t itow = 1000; itow <= 3000; itow += 1000) {
    r.says(dop(itow) + sol(itow) + nav_pvt({.itow_ms = itow}) + velned(itow), itow / 1000.0);
  }
  r.driver->tick(at_s(4), r.ear);
  ASSERT_EQ(r.fixes().size(), 3U);
  for (const GnssFix& fix : r.fixes()) EXPECT_NEAR(fix.velocity_ned->x(), 1, 1e-12);
}

TEST(UbxEpoch, SatellitesByChannelKeepConstellationAndDirection) {
  Receiver r("ubx");
  r.says(sig(1000) + svinfo(1000) + nav_eoe(1000), 1);
  ASSERT_EQ(r.skies().size(), 1U);
  const auto s = r.skies()[0].satellites;
  ASSERT_EQ(s.size(), 2U);
  EXPECT_EQ(s[0].number, 17);
  EXPECT_EQ(s[0].cno_dbhz, 43);
  EXPECT_NEAR(s[0].azimuth_rad.value(), 225 * degree, 1e-12);
  EXPECT_TRUE(s[0].used);
  EXPECT_EQ(s[1].constellation, Constellation::glonass);
  EXPECT_EQ(s[1].number, 1);
  EXPECT_FALSE(s[1].used || s[1].cno_dbhz);
  EXPECT_TRUE(r.fixes().empty()) << "satellites alone are no fix";
}

TEST(UbxEpoch, SignalsOfASatelliteAreOneSatellite) {
  Receiver r("ubx");
  r.says(sig(1000) + nav_eoe(1000), 1);
  const auto s = r.skies().at(0).satellites;
  ASSERT_EQ(s.size(), 2U);
  EXPECT_EQ(s[0].number, 5);
  EXPECT_EQ(s[0].cno_dbhz, 41);
  EXPECT_TRUE(s[0].used);
  EXPECT_FALSE(s[0].elevation_rad || s[1].cno_dbhz);
  EXPECT_EQ(s[1].constellation, Constellation::galileo);
}

TEST(UbxEpoch, NavSatIsOneListHoweverOftenAndInHoweverManyFormsItComes) {
  Receiver r("ubx");
  r.says(svinfo(1000) + nav_sat(1000) + sig(1000) + nav_sat(1000) + nav_eoe(1000), 1);
  ASSERT_EQ(r.skies().size(), 1U);
  EXPECT_EQ(r.skies()[0].satellites[0].number, 5) << "that of NAV-SAT";
}

TEST(UbxEpoch, NmeaBesidePartsSaysNothingNew) {
  const auto sentence = [](const std::string& second) {
    return nmea("GNGGA,1235" + second + ",4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,") +
           nmea("GPGSV,1,1,01,01,40,083,46");
  };
  for (const bool nmea_first : {true, false}) {
    Receiver r("ubx+nmea0183");
    for (std::uint32_t i = 1; i <= 3; ++i) {
      const Octets parts = sol(1000 * i) + svinfo(1000 * i);
      const Octets sentences = sentence(std::to_string(10 + i));
      r.says(nmea_first ? sentences + parts : parts + sentences, 0.02 * i);  // no pause
    }
    r.driver->tick(at_s(4), r.ear);
    ASSERT_EQ(r.fixes().size(), 3U) << nmea_first;
    for (const GnssFix& fix : r.fixes()) EXPECT_TRUE(fix.velocity_ned);
    EXPECT_EQ(r.skies().size(), 3U) << nmea_first;
  }
}

TEST(UbxEpoch, AReopenedLineStartsOver) {
  Receiver r("ubx");
  r.says(sol(1000) + posllh(1000), 1);
  r.driver->restart(at_s(2), r.ear);
  r.says(velned(2000) + status(2000, 3) + nav_eoe(2000), 3);
  ASSERT_EQ(r.fixes().size(), 1U);
  EXPECT_FALSE(r.fixes()[0].position) << "that of before";
}

}  // namespace ubx_epoch_test
}  // namespace drydock::device::test
