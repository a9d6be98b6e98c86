#include "drivers/wire/ubx/ubx.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/bytes.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace ubx_test {

using namespace std::chrono_literals;
using std::chrono::year_month_day;

/// The frames of fixtures/ubx/NOTE.md.
const Reading<Ubx>& golden() {
  static const auto reading = read_stream<Ubx>(fixture("ubx/golden.ubx"));
  return reading;
}

NavPvt pvt(std::size_t index) { return golden().all<NavPvt>().at(index); }

TEST(Ubx, NavPvtGivesWhatGpsdReads) {
  const NavPvt m = pvt(0);
  EXPECT_NEAR(degrees(*m.latitude_rad), 47.285233200, 1e-12);
  EXPECT_NEAR(degrees(*m.longitude_rad), 8.565265000, 1e-12);
  EXPECT_DOUBLE_EQ(*m.ellipsoidal_height_m, 456.789);
  EXPECT_DOUBLE_EQ(*m.mean_sea_level_height_m, 409.123);
  EXPECT_DOUBLE_EQ(*m.horizontal_accuracy_m, 1.234);
  EXPECT_DOUBLE_EQ(*m.vertical_accuracy_m, 2.345);
  EXPECT_DOUBLE_EQ(*m.ground_speed_mps, 1.521);
  EXPECT_NEAR(degrees(*m.course_rad), 350.53778, 1e-9);
  EXPECT_DOUBLE_EQ(*m.velocity_north_mps, 1.5);
  EXPECT_DOUBLE_EQ(*m.velocity_east_mps, -0.25);
  EXPECT_DOUBLE_EQ(*m.velocity_down_mps, -0.04);
  EXPECT_DOUBLE_EQ(*m.speed_accuracy_mps, 0.087);
  EXPECT_DOUBLE_EQ(*m.position_dop, 1.21);
  EXPECT_NEAR(degrees(*m.magnetic_declination_rad), 3.12, 1e-12);
  EXPECT_EQ(m.itow, 302400200ms);
  EXPECT_EQ(m.satellites_used, 17);
  EXPECT_FALSE(m.vehicle_heading_rad);
}

TEST(Ubx, NegativeNanosecondsReachBackIntoTheSecondBefore) {
  const NavPvt m = pvt(0);
  EXPECT_EQ(*m.date,
            (year_month_day{std::chrono::year{2026}, std::chrono::November, std::chrono::day{21}}));
  EXPECT_EQ(*m.time_of_day, 12h - 199'876'543ns);
}

TEST(Ubx, SouthAndWestAreNegative) {
  const NavPvt m = pvt(1);
  EXPECT_NEAR(degrees(*m.latitude_rad), -33.9456789, 1e-12);
  EXPECT_NEAR(degrees(*m.longitude_rad), -179.9999999, 1e-12);
  EXPECT_EQ(m.fix_type, UbxFixType::gnss_and_dr);
  EXPECT_EQ(m.carrier_solution, 2);
  EXPECT_TRUE(m.differential);
  EXPECT_NEAR(degrees(*m.vehicle_heading_rad), 146.305, 1e-9);
  EXPECT_FALSE(m.magnetic_declination_rad);
}

TEST(Ubx, StaleDigitsWithoutAFixAreNoPosition) {
  const NavPvt m = pvt(2);
  EXPECT_FALSE(m.fix_ok);
  EXPECT_FALSE(m.latitude_rad || m.longitude_rad || m.ellipsoidal_height_m);
  EXPECT_FALSE(m.mean_sea_level_height_m || m.velocity_north_mps || m.ground_speed_mps);
  EXPECT_FALSE(m.horizontal_accuracy_m || m.time_accuracy_s || m.position_dop);
  EXPECT_FALSE(m.date || m.time_of_day);
}

TEST(Ubx, AnInvalidPositionLeavesTheVelocity) {
  const NavPvt m = pvt(3);
  EXPECT_FALSE(m.latitude_rad || m.longitude_rad || m.ellipsoidal_height_m);
  EXPECT_DOUBLE_EQ(*m.velocity_down_mps, 0.3);
}

TEST(Ubx, TheOldShortNavPvtIsRead) {
  const NavPvt m = pvt(4);
  EXPECT_NEAR(degrees(*m.latitude_rad), 41.5, 1e-12);
  EXPECT_NEAR(degrees(*m.longitude_rad), -71.0, 1e-12);
  EXPECT_EQ(m.fix_type, UbxFixType::two_d);
  EXPECT_FALSE(m.vehicle_heading_rad || m.magnetic_declination_rad);
}

TEST(Ubx, SatellitesKeepWhatIsKnownOfEach) {
  const auto satellites = golden().all<NavSat>().at(0).satellites;
  ASSERT_EQ(satellites.size(), 6u);
  const UbxSatellite& gps = satellites[0];
  EXPECT_EQ(gps.gnss, UbxGnss::gps);
  EXPECT_EQ(gps.number, 5);
  EXPECT_EQ(gps.cno_dbhz, 44.0);
  EXPECT_NEAR(degrees(*gps.elevation_rad), 63, 1e-12);
  EXPECT_NEAR(degrees(*gps.azimuth_rad), 271, 1e-12);
  EXPECT_DOUBLE_EQ(gps.residual_m, -1.2);
  EXPECT_EQ(gps.quality, 7);
  EXPECT_TRUE(gps.used && gps.has_ephemeris && gps.has_almanac);
  EXPECT_EQ(gps.healthy, true);
  EXPECT_EQ(gps.orbit_source, 1);
  EXPECT_FALSE(satellites[1].used);
}

TEST(Ubx, UnknownAnglesAndUntrackedSignalsAreEmpty) {
  const auto satellites = golden().all<NavSat>().at(0).satellites;
  EXPECT_FALSE(satellites[2].cno_dbhz) << "0 dBHz means not tracked";
  EXPECT_FALSE(satellites[3].elevation_rad || satellites[3].azimuth_rad) << "-91 deg";
  EXPECT_FALSE(satellites[4].elevation_rad) << "91 deg";
  EXPECT_FALSE(satellites[4].healthy);
  EXPECT_NEAR(degrees(*satellites[5].elevation_rad), -5, 1e-12);
  EXPECT_EQ(satellites[5].healthy, false);
}

TEST(Ubx, AnEmptySkyIsAMessageToo) { EXPECT_TRUE(golden().all<NavSat>().at(1).satellites.empty()); }

TEST(Ubx, EndOfEpochNamesItsTimeOfWeek) {
  EXPECT_EQ(golden().all<NavEoe>().at(0).itow, 302400200ms);
}

TEST(Ubx, EncodersRebuildTheGoldenFrames) {
  std::array<std::uint8_t, Ubx::max_frame> out;
  // Four frames are missing here: the one whose fraction of a second is more negative than
  // receivers write it (1), the frame without a fix that has old digits (3), the old form (5), and
  // the position marked as invalid (4). The decoder does not keep invalid values.
  const auto rebuilt = [&](std::size_t frame) {
    const auto message = *Ubx::decode(golden().frames.at(frame));
    std::size_t size = 0;
    std::visit(
        [&](const auto& m) {
          if constexpr (requires { encode(m, out); }) size = encode(m, out);
        },
        message);
    return Buffer(out.begin(), out.begin() + static_cast<long>(size));
  };
  EXPECT_EQ(rebuilt(1), golden().frames[1]);
  EXPECT_EQ(rebuilt(6), golden().frames[6]);
  EXPECT_EQ(rebuilt(7), golden().frames[7]);
}

// UBX-18010854: the six fields are rounded to a hundredth of a second, so nano lies from -5 000 000
// to 994 999 999.
TEST(Ubx, TheFieldsOfUtcAreRoundedToAHundredth) {
  NavPvt m = pvt(1);
  std::array<std::uint8_t, 100> out;
  const auto second_and_nano = [&](std::chrono::nanoseconds time) {
    m.time_of_day = time;
    EXPECT_EQ(encode(m, out), out.size());
    EXPECT_EQ(std::get<NavPvt>(*Ubx::decode(out)).time_of_day, time);
    return std::pair(int{out[6 + 10]}, wire::load_le<std::int32_t>(out, 6 + 16));
  };
  EXPECT_EQ(second_and_nano(12h + 600ms), std::pair(0, 600'000'000));
  EXPECT_EQ(second_and_nano(12h + 994'999'999ns), std::pair(0, 994'999'999));
  EXPECT_EQ(second_and_nano(12h + 995ms), std::pair(1, -5'000'000));
  EXPECT_EQ(second_and_nano(12h + 1s - 1ns), std::pair(1, -1));
  m.time_of_day = 24h - 1ns;
  encode(m, out);
  EXPECT_EQ(out[6 + 6], 3) << "March";
  EXPECT_EQ(out[6 + 7], 1) << "29 February ends in 1 March";
  EXPECT_EQ(out[6 + 8], 0) << "midnight";
}

TEST(Ubx, WhatIsAbsentIsMarkedAbsent) {
  NavPvt m;
  m.fix_ok = true;
  m.fix_type = UbxFixType::three_d;
  m.velocity_north_mps = m.velocity_east_mps = m.velocity_down_mps = 1.0;
  std::array<std::uint8_t, 100> out;
  ASSERT_EQ(encode(m, out), out.size());
  const auto again = std::get<NavPvt>(*Ubx::decode(out));
  EXPECT_FALSE(again.latitude_rad || again.horizontal_accuracy_m || again.position_dop);
  EXPECT_FALSE(again.date || again.time_of_day);
  EXPECT_EQ(again.velocity_down_mps, 1.0);
}

TEST(Ubx, EncodersRefuseABufferThatIsTooSmall) {
  std::array<std::uint8_t, 99> out;
  EXPECT_EQ(encode(NavPvt{}, out), 0u);
  EXPECT_EQ(encode(NavEoe{}, std::span{out}.first(11)), 0u);
}

TEST(Ubx, ADamagedLengthDoesNotStopTheStream) {
  const Buffer claim{0xB5, 0x62, 0x01, 0x07, 0xFF, 0xFF};
  EXPECT_EQ(Ubx::scan(claim), Scan::skip(1));
}

TEST(Ubx, ANavSatWhoseCountContradictsItsLengthIsRefused) {
  Buffer payload(8 + 12, 0);
  payload[5] = 2;
  NavSat m;
  EXPECT_FALSE(read(payload, m));
}

}  // namespace ubx_test
}  // namespace drydock::wire::testing
