#include <gtest/gtest.h>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "tests/drivers/wire/byte_streams.hpp"
#include "tests/drivers/wire/sentences.hpp"

namespace drydock::wire::testing {
namespace nmea0183_encode_test {

using namespace std::chrono_literals;

template <class M, class... Decimals>
std::string encoded(const M& m, const Decimals&... decimals) {
  std::array<std::uint8_t, 200> out;
  const std::size_t size = encode(m, out, decimals...);
  return std::string{as_text(Bytes{out}.first(size))};
}

// The expected sentences are the public examples of fixtures/nmea0183. Their values are typed in
// here.

// A little below zero is no negative zero.
TEST(Nmea0183Encoder, AZeroHasNoSign) {
  Gga m;
  m.mean_sea_level_height_m = -0.004;
  m.geoid_separation_m = -0.6;
  EXPECT_NE(encoded(m).find(",0.00,M,-0.60,M,"), std::string::npos) << encoded(m);
}

TEST(Nmea0183Encoder, Gga) {
  Gga m;
  m.time_of_day = 9h + 27min + 25s;
  m.latitude_rad = (47 * 60 + 17.11399) * arc_minute;
  m.longitude_rad = (8 * 60 + 33.91590) * arc_minute;
  m.quality = 1;
  m.satellites_used = 8;
  m.horizontal_dop = 1.01;
  m.mean_sea_level_height_m = 499.6;
  m.geoid_separation_m = 48.0;
  EXPECT_EQ(encoded(m, NmeaDecimals{.height = 1}),
            "$GPGGA,092725.00,4717.11399,N,00833.91590,E,1,08,1.01,499.6,M,48.0,M,,*5B\r\n");
}

TEST(Nmea0183Encoder, Rmc) {
  Rmc m;
  m.time_of_day = 8h + 35min + 59s;
  m.valid = true;
  m.latitude_rad = (47 * 60 + 17.11437) * arc_minute;
  m.longitude_rad = (8 * 60 + 33.91522) * arc_minute;
  m.speed_mps = 0.004 * 1852 / 3600;
  m.course_rad = radians(77.52);
  m.date = std::chrono::year{2002} / 12 / 9;
  m.mode = 'A';
  EXPECT_EQ(encoded(m),
            "$GPRMC,083559.00,A,4717.11437,N,00833.91522,E,0.004,77.52,091202,,,A*57\r\n");
}

TEST(Nmea0183Encoder, Gsv) {
  Gsv m;
  m.sentences = 3;
  m.sentence_number = 2;
  m.satellites_in_view = 10;
  m.satellites = {{10, radians(7), radians(189), {}},
                  {5, radians(5), radians(220), {}},
                  {9, radians(34), radians(274), 42.0},
                  {18, radians(25), radians(309), 44.0}};
  EXPECT_EQ(encoded(m), "$GPGSV,3,2,10,10,07,189,,05,05,220,,09,34,274,42,18,25,309,44*72\r\n");
}

TEST(Nmea0183Encoder, Gsa) {
  Gsa m;
  m.selection = 'A';
  m.fix_type = 3;
  m.satellites_used = {23, 29, 7, 8, 9, 18, 26, 28};
  m.position_dop = 1.94;
  m.horizontal_dop = 1.18;
  m.vertical_dop = 1.54;
  EXPECT_EQ(encoded(m), "$GPGSA,A,3,23,29,07,08,09,18,26,28,,,,,1.94,1.18,1.54*0D\r\n");
}

TEST(Nmea0183Encoder, VtgZda) {
  Vtg vtg;
  vtg.course_true_rad = radians(77.52);
  vtg.speed_mps = 0.0041 * 1852 / 3600;
  vtg.mode = 'A';
  EXPECT_EQ(encoded(vtg), "$GPVTG,77.52,T,,M,0.004,N,0.008,K,A*06\r\n");
  Zda zda;
  zda.time_of_day = 8h + 27min + 10s;
  zda.date = std::chrono::year{2002} / 9 / 16;
  zda.zone_hours = zda.zone_minutes = 0;
  EXPECT_EQ(encoded(zda), "$GPZDA,082710.00,16,09,2002,00,00*64\r\n");
}

TEST(Nmea0183Encoder, Vhw) {
  Vhw m;
  m.talker = Talker{"VD"};
  m.speed_mps = -0.08 * 1852 / 3600;
  EXPECT_EQ(encoded(m, NmeaDecimals{.speed = 2}), "$VDVHW,,T,,M,-0.08,N,-0.15,K*4B\r\n");
}

TEST(Nmea0183Encoder, Vbw) {
  Vbw m;
  m.water_longitudinal_mps = -7.1 * 1852 / 3600;
  m.water_transverse_mps = 0.1 * 1852 / 3600;
  EXPECT_EQ(encoded(m, NmeaDecimals{.speed = 1}), "$VMVBW,-7.1,0.1,A,,,V,,V,,V*65\r\n");
}

TEST(Nmea0183Encoder, Vlw) {
  Vlw m;
  m.talker = Talker{"VD"};
  m.water_total_m = m.water_trip_m = 13.79 * 1852;
  EXPECT_EQ(encoded(m, NmeaDecimals{.distance = 2}), "$VDVLW,13.79,N,13.79,N,,N,,N*5F\r\n");
}

TEST(Nmea0183Encoder, MinutesCarryIntoDegrees) {
  Gga m;
  m.latitude_rad = -radians(47.0 - 1e-9);
  m.longitude_rad = -radians(180.0 - 1e-9);
  EXPECT_NE(encoded(m).find(",4700.00000,S,18000.00000,W,"), std::string::npos);
}

TEST(Nmea0183Encoder, TimeNeverRoundsPastMidnight) {
  Zda m;
  m.time_of_day = 24h - 1ns;
  EXPECT_NE(encoded(m).find("ZDA,235959.99,"), std::string::npos);
  m.time_of_day = 24h + 500ms;
  EXPECT_NE(encoded(m).find("ZDA,235960.50,"), std::string::npos);
}

TEST(Nmea0183Encoder, RefusesABufferThatIsTooSmall) {
  std::array<std::uint8_t, 22> out;  // one less than the sentence needs
  EXPECT_EQ(encode(Vhw{}, out), 0u);
}

}  // namespace nmea0183_encode_test
}  // namespace drydock::wire::testing
