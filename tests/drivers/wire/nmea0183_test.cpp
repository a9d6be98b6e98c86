#include "drivers/wire/nmea0183/nmea0183.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/wire/byte_streams.hpp"
#include "tests/drivers/wire/sentences.hpp"

namespace drydock::wire::testing {
namespace nmea0183_test {

using namespace std::chrono_literals;

/// The content of the only sentence in the text.
template <class M>
M read(std::string_view text) {
  const auto messages = read_stream<Nmea0183>(as_bytes(text)).template all<M>();
  EXPECT_EQ(messages.size(), 1u) << text;
  return messages.empty() ? M{} : messages.front();
}

constexpr double arc_minute = std::numbers::pi / 180 / 60;

TEST(Nmea0183, GgaOfAReceiverManual) {
  const auto m =
      read<Gga>("$GPGGA,092725.00,4717.11399,N,00833.91590,E,1,08,1.01,499.6,M,48.0,M,,*5B\r\n");
  EXPECT_EQ(m.talker, Talker{"GP"});
  EXPECT_EQ(m.time_of_day, 9h + 27min + 25s);
  EXPECT_NEAR(*m.latitude_rad, (47 * 60 + 17.11399) * arc_minute, 1e-15);
  EXPECT_NEAR(*m.longitude_rad, (8 * 60 + 33.91590) * arc_minute, 1e-15);
  EXPECT_EQ(m.quality, 1);
  EXPECT_EQ(m.satellites_used, 8);
  EXPECT_EQ(m.horizontal_dop, 1.01);
  EXPECT_EQ(m.mean_sea_level_height_m, 499.6);
  EXPECT_EQ(m.geoid_separation_m, 48.0);
  EXPECT_FALSE(m.differential_age_s || m.differential_station);
}

TEST(Nmea0183, APositionWithoutAFixIsNoPosition) {
  const auto m =
      read<Gga>(sentence("GPGGA,092725.00,4717.11399,N,00833.91590,E,0,00,99.99,499.6,M,48.0,M,,"));
  EXPECT_FALSE(m.latitude_rad || m.longitude_rad || m.mean_sea_level_height_m);
  EXPECT_FALSE(m.horizontal_dop) << "99.99 means none";
  EXPECT_EQ(m.time_of_day, 9h + 27min + 25s);
}

TEST(Nmea0183, RmcCarriesDateCourseAndVariation) {
  const auto m =
      read<Rmc>("$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A\r\n");
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.time_of_day, 12h + 35min + 19s);
  EXPECT_EQ(m.date, std::chrono::year{1994} / 3 / 23);
  EXPECT_NEAR(*m.latitude_rad, (48 * 60 + 7.038) * arc_minute, 1e-15);
  EXPECT_NEAR(*m.speed_mps, 22.4 * 1852 / 3600, 1e-12);
  EXPECT_NEAR(degrees(*m.course_rad), 84.4, 1e-12);
  EXPECT_NEAR(degrees(*m.magnetic_variation_rad), -3.1, 1e-12);
  EXPECT_FALSE(m.mode.text() || m.nav_status.text());
}

TEST(Nmea0183, ARmcThatIsVoidGivesOnlyItsTime) {
  for (const auto* body : {"GPRMC,083559.00,V,4717.11437,N,00833.91522,E,0.004,77.52,091202,,,A",
                           "GPRMC,083559.00,A,4717.11437,N,00833.91522,E,0.004,77.52,091202,,,N"}) {
    const auto m = read<Rmc>(sentence(body));
    EXPECT_FALSE(m.valid || m.latitude_rad || m.longitude_rad || m.speed_mps || m.course_rad);
    EXPECT_EQ(m.date, std::chrono::year{2002} / 12 / 9);
  }
}

TEST(Nmea0183, GsvListsSatellitesAndLeavesOutWhatIsNotTracked) {
  const auto m = read<Gsv>("$GPGSV,3,2,10,10,07,189,,05,05,220,,09,34,274,42,18,25,309,44*72\r\n");
  EXPECT_EQ(m.sentences, 3);
  EXPECT_EQ(m.sentence_number, 2);
  EXPECT_EQ(m.satellites_in_view, 10);
  ASSERT_EQ(m.satellites.size(), 4u);
  EXPECT_EQ(m.satellites[0].number, 10);
  EXPECT_NEAR(degrees(*m.satellites[0].azimuth_rad), 189, 1e-12);
  EXPECT_FALSE(m.satellites[0].cno_dbhz);
  EXPECT_NEAR(degrees(*m.satellites[2].elevation_rad), 34, 1e-12);
  EXPECT_EQ(m.satellites[3].cno_dbhz, 44.0);
  EXPECT_FALSE(m.signal);
}

TEST(Nmea0183, GsvOfVersion41EndsInASignalNumber) {
  const auto m = read<Gsv>(sentence("GAGSV,1,1,02,05,33,120,41,24,,,,B"));
  EXPECT_EQ(m.satellites.size(), 2u);
  EXPECT_EQ(m.signal, 11);
}

TEST(Nmea0183, GsaListsTheSatellitesInUse) {
  const auto m = read<Gsa>("$GPGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1*39\r\n");
  EXPECT_EQ(m.selection.text(), "A");
  EXPECT_EQ(m.fix_type, 3);
  EXPECT_EQ(std::vector<int>(m.satellites_used.begin(), m.satellites_used.end()),
            (std::vector<int>{4, 5, 9, 12, 24}));
  EXPECT_EQ(m.position_dop, 2.5);
  EXPECT_EQ(m.horizontal_dop, 1.3);
  EXPECT_EQ(m.vertical_dop, 2.1);
}

TEST(Nmea0183, VtgCarriesBothCourses) {
  const auto m = read<Vtg>("$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\n");
  EXPECT_NEAR(degrees(*m.course_true_rad), 54.7, 1e-12);
  EXPECT_NEAR(degrees(*m.course_magnetic_rad), 34.4, 1e-12);
  EXPECT_NEAR(*m.speed_mps, 5.5 * 1852 / 3600, 1e-12);
}

// The form of version 1.5: the same numbers without letters.
TEST(Nmea0183, VtgOfFourNumbersHasTheSameCoursesAndSpeed) {
  const auto m = read<Vtg>("$GPVTG,054.7,034.4,005.5,010.2*54\r\n");
  EXPECT_NEAR(degrees(*m.course_true_rad), 54.7, 1e-12);
  EXPECT_NEAR(degrees(*m.course_magnetic_rad), 34.4, 1e-12);
  EXPECT_NEAR(*m.speed_mps, 5.5 * 1852 / 3600, 1e-12);
}

TEST(Nmea0183, VtgWithoutAFixGivesNoSpeed) {
  const auto m = read<Vtg>(sentence("GPVTG,54.7,T,,M,0.00,N,0.00,K,N"));
  EXPECT_FALSE(m.speed_mps || m.course_true_rad);
}

TEST(Nmea0183, ZdaCarriesTimeAndDate) {
  const auto m = read<Zda>("$GPZDA,082710.00,16,09,2002,00,00*64\r\n");
  EXPECT_EQ(m.time_of_day, 8h + 27min + 10s);
  EXPECT_EQ(m.date, std::chrono::year{2002} / 9 / 16);
  EXPECT_EQ(m.zone_hours, 0);
}

TEST(Nmea0183, VhwPrefersKnotsToAKilometreFieldThatIsAlwaysZero) {
  EXPECT_NEAR(*read<Vhw>("$HCVHW,,,,,0.2,N,0,K*5B\r\n").speed_mps, 0.2 * 1852 / 3600, 1e-12);
}

TEST(Nmea0183, VhwTakesKilometresPerHourWhereKnotsAreEmpty) {
  EXPECT_NEAR(*read<Vhw>(sentence("VWVHW,,T,,M,,N,7.2,K")).speed_mps, 2.0, 1e-12);
}

TEST(Nmea0183, VhwAsSignalKReadsIt) {
  EXPECT_NEAR(*read<Vhw>("$IIVHW,,T,,M,06.12,N,11.33,K*50\r\n").speed_mps, 3.1484, 5e-5);
  const auto m = read<Vhw>("$SDVHW,182.5,T,181.8,M,0.0,N,0.0,K*4C\r\n");
  EXPECT_NEAR(*m.heading_true_rad, 3.18522588, 5e-9);
  EXPECT_NEAR(*m.heading_magnetic_rad, 3.17300858, 5e-9);
  EXPECT_EQ(m.speed_mps, 0.0);
}

TEST(Nmea0183, VhwMayRunAstern) {
  EXPECT_NEAR(*read<Vhw>("$VDVHW,,T,,M,-0.08,N,-0.15,K*4B\r\n").speed_mps, -0.08 * 1852 / 3600,
              1e-12);
}

TEST(Nmea0183, VbwTakesOnlyWhatHasStatusA) {
  const auto m = read<Vbw>("$VDVBW,55.42,,V,424.33,2321.22,V*49\r\n");
  EXPECT_FALSE(m.water_longitudinal_mps || m.ground_longitudinal_mps || m.ground_transverse_mps);
}

TEST(Nmea0183, VbwReadsWaterAndGround) {
  const auto m = read<Vbw>("$VDVBW,10.1,0.5,A,10.5,0.4,A,,,,*54\r\n");
  EXPECT_NEAR(*m.water_longitudinal_mps, 10.1 * 1852 / 3600, 1e-12);
  EXPECT_NEAR(*m.water_transverse_mps, 0.5 * 1852 / 3600, 1e-12);
  EXPECT_NEAR(*m.ground_longitudinal_mps, 10.5 * 1852 / 3600, 1e-12);
  EXPECT_NEAR(*m.ground_transverse_mps, 0.4 * 1852 / 3600, 1e-12);
  EXPECT_FALSE(m.water_stern_transverse_mps || m.ground_stern_transverse_mps);
}

TEST(Nmea0183, VlwReadsTwoOrFourDistances) {
  const auto two = read<Vlw>("$IIVLW,10.1,N,3.2,N*7C\r\n");
  EXPECT_NEAR(*two.water_total_m, 18705.2, 1e-9);
  EXPECT_FALSE(two.ground_total_m);
  const auto four = read<Vlw>("$IIVLW,10.1,N,3.2,N,1,N,0.1,N*62\r\n");
  EXPECT_NEAR(*four.ground_trip_m, 185.2, 1e-9);
}

TEST(Nmea0183, AnEmptyFieldLeavesTheOthers) {
  const auto m = read<Vlw>("$SDVLW,,N,545.6,N,1109.4,N,393.6,N*44\r\n");
  EXPECT_FALSE(m.water_total_m);
  EXPECT_NEAR(*m.water_trip_m, 545.6 * 1852, 1e-6);
  EXPECT_NEAR(*m.ground_total_m, 1109.4 * 1852, 1e-6);
}

TEST(Nmea0183, AMalformedFieldReadsAsEmptyAndLeavesTheOthers) {
  const auto m =
      read<Gga>(sentence("GNGGA,9h2725,4799.11399,N,00833.91590,E,1,x,1e1,nan,M,48.0,M,2.5,"));
  EXPECT_FALSE(m.time_of_day || m.latitude_rad || m.satellites_used || m.horizontal_dop);
  EXPECT_FALSE(m.mean_sea_level_height_m);
  EXPECT_EQ(m.quality, 1);
  EXPECT_EQ(m.differential_age_s, 2.5);
  EXPECT_EQ(m.geoid_separation_m, 48.0);
}

TEST(Nmea0183, TimesMayHaveAnyDecimalsAndALeapSecond) {
  EXPECT_EQ(read<Zda>(sentence("GPZDA,235960.123456789,31,12,2016,,")).time_of_day,
            24h + 123'456'789ns);
  EXPECT_EQ(read<Zda>(sentence("GPZDA,010203.,31,12,2016,,")).time_of_day, 1h + 2min + 3s);
  EXPECT_FALSE(read<Zda>(sentence("GPZDA,246060,31,02,2016,,")).time_of_day);
  EXPECT_FALSE(read<Zda>(sentence("GPZDA,246060,31,02,2016,,")).date) << "31 February";
}

TEST(Nmea0183, NumbersOfManyDigitsAreReadExactly) {
  const auto m = read<Gga>(sentence(
      "GPGGA,1,4717.1139912345678,N,00000,E,1,,,0.123456789012345678,M,-000000000000000001,M,,"));
  EXPECT_EQ(m.mean_sea_level_height_m, 0.123456789012345678);
  EXPECT_EQ(m.geoid_separation_m, -1.0);
  EXPECT_NEAR(*m.latitude_rad, (47 * 60 + 17.1139912345678) * arc_minute, 1e-15);
}

TEST(Nmea0183, AnyLineEndAndAnyHexCaseWillDo) {
  for (const auto* end : {"\r\n", "\n", "\r"}) {
    const auto reading = read_stream<Nmea0183>(as_bytes(
        std::string{"$HCVHW,,,,,0.2,N,0,K*5b"} + end + "$GPZDA,082710.00,16,09,2002,00,00*64\r\n"));
    EXPECT_EQ(reading.messages.size(), 2u);
    EXPECT_EQ(reading.counters.bytes_skipped, 0u);
  }
}

TEST(Nmea0183, ASentenceWithoutAChecksumIsNoFrame) {
  const auto reading = read_stream<Nmea0183>(
      as_bytes("$VWVHW,45.0,T,43.0,M,3.5,N,6.4,K\r\n$HCVHW,,,,,0.2,N,0,K*5B\r\n"));
  EXPECT_EQ(reading.frames.size(), 1u);
  EXPECT_EQ(reading.counters.bad_checksums, 0u);
}

TEST(Nmea0183, ADollarInsideASentenceStartsOver) {
  const auto reading =
      read_stream<Nmea0183>(as_bytes("$VWVHW,45.0,T,43.$HCVHW,,,,,0.2,N,0,K*5B\r\n"));
  EXPECT_EQ(reading.frames.size(), 1u);
  EXPECT_EQ(reading.counters.bytes_skipped, 17u);
}

TEST(Nmea0183, ProprietarySentencesAreSoundButHoldNoMessage) {
  const auto reading = read_stream<Nmea0183>(as_bytes(sentence("PUBX,04,073731.00,091202")));
  EXPECT_EQ(reading.frames.size(), 1u);
  EXPECT_TRUE(reading.messages.empty());
}

TEST(Nmea0183, ASentenceThatNeverEndsIsGivenUp) {
  const auto reading = read_stream<Nmea0183>(
      as_bytes("$" + std::string(5000, 'A') + "\r\n$HCVHW,,,,,0.2,N,0,K*5B\r\n"));
  EXPECT_EQ(reading.frames.size(), 1u);
}

}  // namespace nmea0183_test
}  // namespace drydock::wire::testing
