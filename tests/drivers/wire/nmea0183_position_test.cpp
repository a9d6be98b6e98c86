#include "drivers/wire/nmea0183/nmea0183_position.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "tests/drivers/wire/byte_streams.hpp"
#include "tests/drivers/wire/sentences.hpp"

namespace drydock::wire::testing {
namespace nmea0183_position_test {

using namespace std::chrono_literals;

template <class M>
M only(std::string_view text) {
  const auto messages = read_stream<Nmea0183>(as_bytes(text)).template all<M>();
  EXPECT_EQ(messages.size(), 1u) << text;
  return messages.empty() ? M{} : messages.front();
}

template <class M>
std::string written(const M& m, const NmeaDecimals& decimals) {
  std::array<std::uint8_t, 200> out;
  return std::string{as_text(Bytes{out}.first(encode(m, out, decimals)))};
}

constexpr auto gns =
    "$GNGNS,103600.01,5114.51176,N,00012.29380,W,ANNN,07,1.18,111.5,45.6,,,V*00\r\n";
constexpr auto gll = "$GPGLL,4717.11364,N,00833.91565,E,092321.00,A,A*60\r\n";
constexpr auto gst = "$GPGST,172814.0,0.006,0.023,0.020,273.6,0.023,0.020,0.031*6A\r\n";
constexpr auto hdt = "$GPHDT,75.5664,T*36\r\n";

TEST(Nmea0183, GnsOfAReceiverManual) {
  const auto m = only<Gns>(gns);
  EXPECT_EQ(m.time_of_day, 10h + 36min + 10ms);
  EXPECT_NEAR(*m.latitude_rad, (51 * 60 + 14.51176) * arc_minute, 1e-15);
  EXPECT_NEAR(*m.longitude_rad, -12.29380 * arc_minute, 1e-15);
  EXPECT_EQ((std::string_view{m.modes.data(), m.modes.size()}), "ANNN");
  EXPECT_EQ(m.satellites_used, 7);
  EXPECT_EQ(m.horizontal_dop, 1.18);
  EXPECT_EQ(m.mean_sea_level_height_m, 111.5);
  EXPECT_EQ(m.geoid_separation_m, 45.6);
  EXPECT_FALSE(m.differential_age_s || m.differential_station);
  EXPECT_EQ(m.nav_status, Letter{'V'});
  EXPECT_EQ(written(m, {.height = 1}), gns);
}

TEST(Nmea0183, AGnsInWhichNoConstellationHasAFixIsNoPosition) {
  for (const auto* modes : {"NNNN", "N", ""}) {
    const auto m = only<Gns>(
        sentence(std::string{"GNGNS,103600,5114.5,N,00012.2,W,"} + modes + ",00,,111.5,45.6,,"));
    EXPECT_FALSE(m.latitude_rad || m.longitude_rad || m.mean_sea_level_height_m) << modes;
  }
  EXPECT_TRUE(only<Gns>(sentence("GNGNS,103600,5114.5,N,00012.2,W,NNR,,,,,,")).latitude_rad);
}

/// Of SignalK's test sentences: a receiver that fills in no mode.
TEST(Nmea0183, AGnsWithoutAnyModeKeepsItsPosition) {
  const auto m = only<Gns>("$GPGNS,111648.00,0235.0379,S,04422.1450,W,,,,,,,,S*2A\r\n");
  EXPECT_NEAR(*m.latitude_rad, -(2 * 60 + 35.0379) * arc_minute, 1e-15);
  EXPECT_TRUE(m.longitude_rad);
}

/// A Unicore UM981 sends a minus before the longitude; SignalK tests with the hemisphere Q.
TEST(Nmea0183, APositionIsBothOrNone) {
  const auto gll_message = only<Gll>(sentence("GNGLL,5327.03598945,N,-0214.41467156,W,130058,A,A"));
  EXPECT_FALSE(gll_message.latitude_rad || gll_message.longitude_rad);
  EXPECT_TRUE(gll_message.valid);
  const auto rmc =
      only<Rmc>(sentence("GPRMC,085412,A,5222.3198,N,00454.5784,Q,0.58,251.34,030414,,"));
  EXPECT_FALSE(rmc.latitude_rad || rmc.longitude_rad);
  EXPECT_TRUE(rmc.speed_mps && rmc.course_rad);
  const auto gga = only<Gga>(sentence("GPGGA,172814,,N,12202.26,W,2,6,1.2,18.893,M,-25.669,M,,"));
  EXPECT_FALSE(gga.latitude_rad || gga.longitude_rad);
  const auto of_gns = only<Gns>(sentence("GNGNS,103600,5114.5,,00012.2,W,AN,07,1.2,111.5,45.6,,"));
  EXPECT_FALSE(of_gns.latitude_rad || of_gns.longitude_rad);
}

TEST(Nmea0183, GllOfAReceiverManual) {
  const auto m = only<Gll>(gll);
  EXPECT_NEAR(*m.latitude_rad, (47 * 60 + 17.11364) * arc_minute, 1e-15);
  EXPECT_NEAR(*m.longitude_rad, (8 * 60 + 33.91565) * arc_minute, 1e-15);
  EXPECT_EQ(m.time_of_day, 9h + 23min + 21s);
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(written(m, {}), gll);
}

TEST(Nmea0183, AGllThatIsVoidGivesOnlyItsTime) {
  for (const auto* status : {"V", "V,N", "A,N", ""}) {
    const auto m =
        only<Gll>(sentence(std::string{"GPGLL,4717.11364,N,00833.91565,E,092321.00,"} + status));
    EXPECT_FALSE(m.valid || m.latitude_rad || m.longitude_rad) << status;
    EXPECT_EQ(m.time_of_day, 9h + 23min + 21s);
  }
}

TEST(Nmea0183, GstOfTwoReceiverManuals) {
  const auto m = only<Gst>(gst);
  EXPECT_EQ(m.time_of_day, 17h + 28min + 14s);
  EXPECT_EQ(m.range_rms_m, 0.006);
  EXPECT_EQ(m.semi_major_m, 0.023);
  EXPECT_EQ(m.semi_minor_m, 0.020);
  EXPECT_NEAR(degrees(*m.orientation_rad), 273.6, 1e-12);
  EXPECT_EQ(m.latitude_sigma_m, 0.023);
  EXPECT_EQ(m.longitude_sigma_m, 0.020);
  EXPECT_EQ(m.height_sigma_m, 0.031);
  EXPECT_EQ(written(m, {.time = 1, .angle = 1, .distance = 3}), gst);
  const auto sparse = only<Gst>("$GPGST,082356.00,1.8,,,,1.7,1.3,2.2*7E\r\n");
  EXPECT_FALSE(sparse.semi_major_m || sparse.semi_minor_m || sparse.orientation_rad);
  EXPECT_EQ(sparse.height_sigma_m, 2.2);
}

TEST(Nmea0183, HeadingFromTrueNorth) {
  const auto m = only<Hdt>(hdt);
  EXPECT_NEAR(degrees(*m.heading_rad), 75.5664, 1e-12);
  EXPECT_EQ(written(m, {.angle = 4}), hdt);
  // A sentence from a SkyTraq PX1172RH.
  constexpr auto ths = "$GNTHS,244.17,A*1D\r\n";
  const auto with_mode = only<Ths>(ths);
  EXPECT_NEAR(degrees(*with_mode.heading_rad), 244.17, 1e-12);
  EXPECT_EQ(with_mode.mode, Letter{'A'});
  EXPECT_EQ(written(with_mode, {}), ths);
  EXPECT_FALSE(only<Ths>(sentence("GPTHS,244.17,V")).heading_rad) << "V: not valid";
}

// Of a masthead compass (bundg_zeus_9.log of gpsd) and of a pilot (pypilot.log).
TEST(Nmea0183, HeadingFromMagneticNorth) {
  constexpr auto hdg = "$SDHDG,229.8,,,1.3,E*36\r\n", hdm = "$APHDM,218.634,M*39\r\n";
  const auto m = only<Hdg>(hdg);
  EXPECT_NEAR(degrees(*m.sensor_heading_rad), 229.8, 1e-12);
  EXPECT_FALSE(m.deviation_rad);
  EXPECT_NEAR(degrees(*m.variation_rad), 1.3, 1e-12);
  EXPECT_EQ(written(m, {.angle = 1}), hdg);
  const auto west = only<Hdg>(sentence("HCHDG,98.3,0.5,W,12.6,W"));
  EXPECT_NEAR(degrees(*west.deviation_rad), -0.5, 1e-12);
  EXPECT_NEAR(degrees(*west.variation_rad), -12.6, 1e-12);
  EXPECT_FALSE(only<Hdg>(sentence("HCHDG,98.3,0.5,,,W")).deviation_rad) << "half a value is none";
  const auto plain = only<Hdm>(hdm);
  EXPECT_NEAR(degrees(*plain.heading_rad), 218.634, 1e-12);
  EXPECT_EQ(written(plain, {.angle = 3}), hdm);
}

}  // namespace nmea0183_position_test
}  // namespace drydock::wire::testing
