#include "tests/drivers/device/gnss_receiver.hpp"

/// Fixes from NMEA 0183 sentences: those of one time of day are one epoch.
namespace drydock::device::test {
namespace gnss_sentences_test {

using measurement::FixType;
using measurement::GnssFix;
using measurement::GnssSatellites;
using namespace std::chrono;

// Widely published examples of the format (gpsinformation.org): 23 March 1994, 12:35:19.
const std::string gga = "GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,";
const std::string rmc = "GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W";
const std::string gsa = "GPGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1";

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

}  // namespace gnss_sentences_test
}  // namespace drydock::device::test
