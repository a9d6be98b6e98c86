#include "tests/drivers/device/gnss_receiver.hpp"

/// Fixes of UBX receivers.
namespace drydock::device::test {
namespace gnss_driver_test {

using measurement::FixType;
using measurement::GnssFix;
using namespace std::chrono;

TEST(GnssDriver, UbxFixIsPublishedWhole) {
  Receiver r("ubx");
  r.says(nav_pvt({}), 1);
  ASSERT_EQ(r.fixes().size(), 1U);
  const GnssFix fix = r.fixes()[0];
  EXPECT_EQ(fix.type, FixType::three_d);
  EXPECT_NEAR(fix.position->latitude_rad, 47.25 * degree, 1e-12);
  EXPECT_NEAR(fix.position->longitude_rad, 8.5 * degree, 1e-12);
  EXPECT_NEAR(fix.ellipsoidal_height_m.value(), 450, 1e-9);
  EXPECT_NEAR(fix.velocity_ned->x(), 1, 1e-12);
  EXPECT_NEAR(fix.velocity_ned->y(), -0.5, 1e-12);
  EXPECT_NEAR(fix.velocity_ned->z(), 0.25, 1e-12);
  EXPECT_EQ(fix.satellites_used, 11);
  EXPECT_EQ(fix.origin.device_time, 1s);
  const auto utc = sys_days{2026y / March / 4} + 5h + 6min + 7s - 250us;
  EXPECT_EQ(fix.utc, Stamp{utc.time_since_epoch()});
}

TEST(GnssDriver, UbxWithoutFixHasNoPositionWhateverStandsInTheField) {
  Receiver r("ubx");
  r.says(nav_pvt({.itow_ms = 1000, .fix_type = 0, .flags = 0}), 1);
  r.says(nav_pvt({.itow_ms = 2000, .fix_type = 3, .flags = 0}), 2);  // outside its own masks
  r.says(nav_pvt({.itow_ms = 3000, .fix_type = 3, .flags = 1, .flags3 = 1}), 3);  // invalidLlh
  r.says(nav_pvt({.itow_ms = 4000, .fix_type = 5, .flags = 1}), 4);               // time only
  ASSERT_EQ(r.fixes().size(), 4U);
  for (const GnssFix& fix : r.fixes()) EXPECT_FALSE(fix.position);
  EXPECT_EQ(r.fixes()[0].type, FixType::none);
  EXPECT_EQ(r.fixes()[1].type, FixType::none);
  EXPECT_EQ(r.fixes()[3].type, FixType::time_only);
}

/// NAV-PVT, flags: bit 0 gnssFixOK, bit 1 diffSoln, bits 6 and 7 carrSoln (1 float, 2 fixed).
TEST(GnssDriver, UbxTellsDifferentialAndRtkSolutions) {
  using enum measurement::FixQuality;
  Receiver r("ubx");
  const std::uint8_t flags[] = {0x01, 0x03, 0x43, 0x83, 0x00};
  std::uint32_t itow_ms = 0;
  for (const auto each : flags) {
    itow_ms += 1000;
    r.says(nav_pvt({.itow_ms = itow_ms, .flags = each}), itow_ms / 1000.0);
  }
  r.says(nav_pvt({.itow_ms = 6000, .fix_type = 1, .flags = 1}), 6);
  std::vector<std::optional<measurement::FixQuality>> heard;
  for (const GnssFix& fix : r.fixes()) heard.push_back(fix.quality);
  EXPECT_EQ(heard, (decltype(heard){autonomous, differential, rtk_float, rtk_fixed, std::nullopt,
                                    dead_reckoning}));
}

TEST(GnssDriver, SameTimeOfWeekTwiceIsOneFix) {
  Receiver r("ubx");
  r.says(nav_pvt({}) + nav_pvt({}) + nav_eoe(1000) + nav_pvt({.itow_ms = 2000}), 1);
  EXPECT_EQ(r.fixes().size(), 2U);
}

TEST(GnssDriver, FixBehindOtherMessagesOfItsEpochIsAsOldAsTheFirstOfThem) {
  Receiver r("ubx", 38400);
  const Octets sat = nav_sat(1000), pvt = nav_pvt({});
  r.says(sat + pvt, 1);
  const double on_the_line = static_cast<double>(sat.size() + pvt.size()) * 10 / 38400;
  const measurement::Origin origin = r.fixes().at(0).origin;
  EXPECT_NEAR(measurement::seconds(at_s(1) - origin.valid_at), on_the_line, 2e-9);
  EXPECT_EQ(origin.received_at, at_s(1));
}

TEST(GnssDriver, MixedLineGivesEachEpochOnceAndFromUbx) {
  Receiver r("ubx");
  for (int epoch = 1; epoch <= 3; ++epoch) {
    const std::string second = std::to_string(10 + epoch);
    r.says(nmea("GNGGA,1235" + second + ",4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,") +
               nav_pvt({.itow_ms = 1000U * static_cast<unsigned>(epoch)}) +
               nmea("GNRMC,1235" + second + ",A,4807.038,N,01131.000,E,022.4,084.4,230394,,"),
           epoch);
  }
  r.driver->tick(at_s(4), r.ear);
  ASSERT_EQ(r.fixes().size(), 3U);
  for (const GnssFix& fix : r.fixes()) EXPECT_TRUE(fix.velocity_ned);
}

}  // namespace gnss_driver_test
}  // namespace drydock::device::test
