#include "tests/drivers/device/gnss_receiver.hpp"

namespace drydock::device::test {
namespace gnss_driver_test {

using measurement::Constellation;
using measurement::FixType;
using measurement::GnssFix;
using measurement::GnssSatellites;
using namespace std::chrono;

// Widely published examples of the format (gpsinformation.org): 23 March 1994, 12:35:19.
const std::string gga = "GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,";
const std::string rmc = "GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W";
const std::string gsa = "GPGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1";

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

/// NMEA 0183, GGA: 1 autonomous, 2 differential, 4 RTK fixed, 5 RTK float, 6 estimated.
TEST(GnssDriver, NmeaTellsTheQualityOfItsFix) {
  using enum measurement::FixQuality;
  const auto quality = [](const Octets& sentence) {
    Receiver r("nmea0183");
    r.says(sentence, 1);
    r.driver->tick(at_s(2), r.ear);
    return r.fixes().at(0).quality;
  };
  const auto of_gga = [&](const std::string& digit) {
    return quality(
        nmea("GPGGA,123519,4807.038,N,01131.000,E," + digit + ",08,0.9,545.4,M,46.9,M,,"));
  };
  EXPECT_EQ(of_gga("1"), autonomous);
  EXPECT_EQ(of_gga("2"), differential);
  EXPECT_EQ(of_gga("4"), rtk_fixed);
  EXPECT_EQ(of_gga("5"), rtk_float);
  EXPECT_EQ(of_gga("6"), dead_reckoning);
  EXPECT_EQ(of_gga("0"), std::nullopt);
  const auto of_gns = [&](const std::string& modes) {
    return quality(nmea("GNGNS,123519,4807.038,N,01131.000,E," + modes + ",08,0.9,545.4,46.9,,"));
  };
  EXPECT_EQ(of_gns("AD"), differential);
  EXPECT_EQ(of_gns("RF"), rtk_fixed);
  EXPECT_EQ(of_gns("NA"), autonomous);
  EXPECT_EQ(quality(nmea(rmc)), std::nullopt) << "before NMEA 2.3 it has no mode";
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

TEST(GnssDriver, UbxSatellitesKeepConstellationAndUnknowns) {
  Receiver r("ubx");
  r.says(nav_sat(1000), 1);
  const auto all = r.ear.all<GnssSatellites>();
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].satellites.size(), 2U);
  const auto& galileo = all[0].satellites[0];
  EXPECT_EQ(galileo.constellation, Constellation::galileo);
  EXPECT_EQ(galileo.number, 5);
  EXPECT_EQ(galileo.cno_dbhz, 41);
  EXPECT_NEAR(galileo.azimuth_rad.value(), 270 * degree, 1e-12);
  EXPECT_TRUE(galileo.used);
  const auto& glonass = all[0].satellites[1];
  EXPECT_EQ(glonass.constellation, Constellation::glonass);
  EXPECT_FALSE(glonass.cno_dbhz);
  EXPECT_FALSE(glonass.elevation_rad);
}

TEST(GnssDriver, NmeaSentencesOfOneTimeAreOneFix) {
  Receiver r("nmea0183");
  r.says(nmea(gga) + nmea(gsa) + nmea(rmc), 1);
  EXPECT_TRUE(r.fixes().empty());  // more may come
  r.driver->tick(r.driver->deadline().value(), r.ear);
  ASSERT_EQ(r.fixes().size(), 1U);
  const GnssFix fix = r.fixes()[0];
  EXPECT_EQ(fix.type, FixType::three_d);
  EXPECT_NEAR(fix.position->latitude_rad, (48 + 7.038 / 60) * degree, 1e-12);
  EXPECT_NEAR(fix.position->longitude_rad, (11 + 31.0 / 60) * degree, 1e-12);
  EXPECT_NEAR(fix.mean_sea_level_height_m.value(), 545.4, 1e-9);
  EXPECT_NEAR(fix.ellipsoidal_height_m.value(), 592.3, 1e-9);
  EXPECT_NEAR(fix.ground_speed_mps.value(), 22.4 * knot, 1e-12);
  EXPECT_NEAR(fix.course_rad.value(), 84.4 * degree, 1e-12);
  EXPECT_FALSE(fix.velocity_ned);  // the receiver did not measure the vertical part
  EXPECT_EQ(fix.satellites_used, 8);
  EXPECT_EQ(fix.position_dop, 2.5);
  const auto utc = sys_days{1994y / March / 23} + 12h + 35min + 19s;
  EXPECT_EQ(fix.utc, Stamp{utc.time_since_epoch()});
  EXPECT_EQ(fix.origin.device_time, 12h + 35min + 19s);
}

TEST(GnssDriver, NextTimeOfDayClosesTheEpoch) {
  Receiver r("nmea0183");
  r.says(
      nmea(gga) + nmea(rmc) + nmea("GPGGA,123520,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,"),
      1);
  EXPECT_EQ(r.fixes().size(), 1U);
}

TEST(GnssDriver, StragglerOfAClosedEpochIsNoSecondFixAndIsTold) {
  Receiver r("nmea0183", 38400);
  r.says(nmea(gga), 1);
  r.driver->tick(at_s(1.2), r.ear);
  r.says(nmea(rmc), 1.3);
  r.driver->tick(at_s(1.5), r.ear);
  EXPECT_EQ(r.fixes().size(), 1U);
  EXPECT_EQ(r.ear.refusals, std::vector<std::string>{
                                "RMC came after the epoch to which it belongs, and was left out"});
}

TEST(GnssDriver, NmeaWithoutFixHasNoPosition) {
  Receiver r("nmea0183");
  r.says(nmea("GPGGA,123519,4807.038,N,01131.000,E,0,00,,,M,,M,,"), 1);  // digits, but quality 0
  r.says(nmea("GPGGA,123520,4807.038,N,01131.000,E,1,03,,,M,,M,,") +
             nmea("GPRMC,123520,V,4807.038,N,01131.000,E,,,230394,,"),
         2);                                                             // the RMC contradicts
  r.says(nmea("GPGGA,123521,4807.038,N,01131.000,E,8,03,,,M,,M,,"), 3);  // simulator
  r.driver->tick(at_s(4), r.ear);
  ASSERT_EQ(r.fixes().size(), 3U);
  for (const GnssFix& fix : r.fixes()) {
    EXPECT_FALSE(fix.position);
    EXPECT_EQ(fix.type, FixType::none);
  }
}

TEST(GnssDriver, GnsGivesTheFixAndGstItsAccuracy) {
  Receiver r("nmea0183");
  r.says(nmea("GNGNS,014035.00,4332.69262,S,17235.48549,E,RR,13,0.9,25.63,11.24,,") +
             nmea("GPGNS,014035.00,,,,,,8,,,,1.0,23") + nmea("GLGNS,014035.00,,,,,,5,,,,1.0,23") +
             nmea("GNGST,014035.00,0.006,0.023,0.020,273.6,0.03,0.04,0.05"),
         1);
  r.driver->tick(at_s(2), r.ear);
  ASSERT_EQ(r.fixes().size(), 1U);
  const GnssFix fix = r.fixes()[0];
  EXPECT_EQ(fix.type, FixType::three_d);
  EXPECT_NEAR(fix.position->latitude_rad, -(43 + 32.69262 / 60) * degree, 1e-12);
  EXPECT_NEAR(fix.ellipsoidal_height_m.value(), 36.87, 1e-9);
  EXPECT_EQ(fix.satellites_used, 13);
  EXPECT_NEAR(fix.horizontal_accuracy_m.value(), 0.05, 1e-12);
  EXPECT_EQ(fix.vertical_accuracy_m, 0.05);
}

TEST(GnssDriver, GllAloneIsAFixInThePlane) {
  Receiver r("nmea0183");
  r.says(nmea("GPGLL,4717.11364,N,00833.91565,E,092321.00,A,A"), 1);
  r.says(nmea("GPGLL,4717.11364,N,00833.91565,E,092322.00,V,N"), 2);
  r.driver->tick(at_s(3), r.ear);
  ASSERT_EQ(r.fixes().size(), 2U);
  EXPECT_EQ(r.fixes()[0].type, FixType::two_d);
  EXPECT_NEAR(r.fixes()[0].position->longitude_rad, (8 + 33.91565 / 60) * degree, 1e-12);
  EXPECT_EQ(r.fixes()[1].type, FixType::none);
  EXPECT_FALSE(r.fixes()[1].position);
}

TEST(GnssDriver, GnsWithoutAMeasuredConstellationHasNoPosition) {
  Receiver r("nmea0183");
  r.says(nmea("GNGNS,014035,4332.69262,S,17235.48549,E,NS,13,0.9,25.63,11.24,,"), 1);
  r.driver->tick(at_s(2), r.ear);
  ASSERT_EQ(r.fixes().size(), 1U);
  EXPECT_EQ(r.fixes()[0].type, FixType::none);
  EXPECT_FALSE(r.fixes()[0].position);
}

TEST(GnssDriver, GsvGroupsOfAnEpochAreOneList) {
  Receiver r("nmea0183");
  r.says(nmea(gga) + nmea("GPGSA,A,3,01,14,,,,,,,,,,,2.5,1.3,2.1") +
             nmea("GPGSV,2,1,05,01,40,083,46,02,17,308,41,12,07,344,39,14,22,228,45") +
             nmea("GPGSV,2,2,05,33,10,120,") + nmea("GLGSV,1,1,01,65,50,010,30"),
         1);
  r.driver->tick(at_s(2), r.ear);
  const auto all = r.ear.all<GnssSatellites>();
  ASSERT_EQ(all.size(), 1U);
  const auto& s = all[0].satellites;
  ASSERT_EQ(s.size(), 6U);
  EXPECT_EQ(s[0].number, 1);
  EXPECT_TRUE(s[0].used);
  EXPECT_FALSE(s[1].used);
  EXPECT_TRUE(s[3].used);
  EXPECT_EQ(s[4].constellation, Constellation::sbas);
  EXPECT_EQ(s[4].number, 120);  // NMEA 33 means PRN 120
  EXPECT_FALSE(s[4].cno_dbhz);
  EXPECT_EQ(s[5].constellation, Constellation::glonass);
  EXPECT_EQ(s[5].number, 1);
}

TEST(GnssDriver, GroupWithALostSentenceIsNotPublished) {
  Receiver r("nmea0183");
  r.says(nmea(gga) + nmea("GPGSV,3,1,09,01,40,083,46,02,17,308,41,12,07,344,39,14,22,228,45") +
             nmea("GPGSV,3,3,09,03,40,083,46"),
         1);
  r.driver->tick(at_s(2), r.ear);
  EXPECT_TRUE(r.ear.all<GnssSatellites>().empty());
  EXPECT_EQ(r.fixes().size(), 1U);
}

TEST(GnssDriver, ASatelliteOnSeveralSignalsKeepsItsStrongestAndItsDirection) {
  Receiver r("nmea0183");  // signals of NMEA 4.10: 1 is L1 C/A, 6 is L2 CM, 8 is L5
  r.says(nmea(gga) + nmea("GNGSA,A,3,01,,,,,,,,,,,,2.5,1.3,2.1,1") +
             nmea("GPGSV,1,1,02,01,40,083,41,02,17,308,,1") + nmea("GPGSV,1,1,01,01,,,44,6") +
             nmea("GPGSV,1,1,02,01,40,083,39,02,17,308,30,8"),
         1);
  r.driver->tick(at_s(2), r.ear);
  const auto all = r.ear.all<GnssSatellites>();
  ASSERT_EQ(all.size(), 1U);
  const auto& s = all[0].satellites;
  ASSERT_EQ(s.size(), 2U);
  EXPECT_EQ(s[0].cno_dbhz, 44);
  EXPECT_NEAR(s[0].azimuth_rad.value(), 83 * degree, 1e-12);
  EXPECT_TRUE(s[0].used);
  EXPECT_EQ(s[1].cno_dbhz, 30);
}

TEST(GnssDriver, EpochsThatBeginWithoutATimeStayApartOnALineWithoutPauses) {
  Receiver r("nmea0183");
  const auto epoch = [](const std::string& second, const std::string& satellite) {
    return nmea("GPGSA,A,3," + satellite + ",11,,,,,,,,,,,2.5,1.3,2.1") +
           nmea("GPGSV,1,1,02," + satellite + ",40,083,4" + satellite.substr(1) + ",11,20,100,30") +
           nmea("GPVTG,084.4,T,,M,0" + satellite + ",N,,K") +
           nmea("GPGGA,1235" + second + ",4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,");
  };
  r.says(epoch("19", "01") + epoch("20", "02") + epoch("21", "03"), 1);
  r.driver->tick(at_s(2), r.ear);
  const auto skies = r.ear.all<GnssSatellites>();
  ASSERT_EQ(skies.size(), 3U);
  ASSERT_EQ(r.fixes().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(skies[i].satellites.size(), 2U);
    EXPECT_EQ(skies[i].satellites[0].number, i + 1);
    EXPECT_TRUE(skies[i].satellites[0].used && skies[i].satellites[1].used);
    EXPECT_NEAR(r.fixes()[i].ground_speed_mps.value(), (static_cast<double>(i) + 1) * knot, 1e-12);
    EXPECT_EQ(r.fixes()[i].origin.device_time, 12h + 35min + seconds{19 + static_cast<int>(i)});
  }
}

TEST(GnssDriver, ALeapSecondBelongsToItsDay) {
  Receiver r("nmea0183");
  r.says(nmea("GPRMC,235960,A,4807.038,N,01131.000,E,022.4,084.4,311216,,"), 1);
  r.says(nmea("GPRMC,000000,A,4807.038,N,01131.000,E,022.4,084.4,010117,,"), 2);
  r.driver->tick(at_s(3), r.ear);
  ASSERT_EQ(r.fixes().size(), 2U);
  // A count of seconds since 1970 cannot express the leap second: both are the first second of
  // 2017.
  const auto new_year = Stamp{sys_days{2017y / January / 1}.time_since_epoch()};
  EXPECT_EQ(r.fixes()[0].utc, new_year);
  EXPECT_EQ(r.fixes()[1].utc, new_year);
  EXPECT_EQ(r.fixes()[0].origin.device_time, 24h);
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
