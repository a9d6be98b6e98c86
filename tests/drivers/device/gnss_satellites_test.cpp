#include "tests/drivers/device/gnss_receiver.hpp"

/// Satellites in view, of UBX and of GSV sentences.
namespace drydock::device::test {
namespace gnss_satellites_test {

using measurement::Constellation;
using measurement::GnssSatellites;

// A widely published example of the format (gpsinformation.org).
const std::string gga = "GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,";

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

}  // namespace gnss_satellites_test
}  // namespace drydock::device::test
