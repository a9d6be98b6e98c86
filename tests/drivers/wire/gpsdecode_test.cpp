#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "drivers/wire/ubx/ubx.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Another program decodes the output of our encoders: gpsd's gpsdecode, which converts a stream to
/// JSON.
namespace drydock::wire::testing {
namespace gpsdecode_test {

using namespace std::chrono_literals;

class Gpsdecode : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v gpsdecode >/dev/null") != 0) {
      GTEST_SKIP() << "gpsdecode is not installed (package gpsd-clients)";
    }
  }

  /// The first report of a class.
  static nlohmann::json report(Bytes stream, const std::string& report_class) {
    const auto path = std::filesystem::temp_directory_path() /
                      ("drydock_gpsdecode_" + std::to_string(::getpid()));
    std::ofstream{path, std::ios::binary} << as_text(stream);
    std::FILE* pipe = ::popen(("gpsdecode -j < " + path.string()).c_str(), "r");
    std::string text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
    ::pclose(pipe);
    std::filesystem::remove(path);
    const std::size_t start = text.find("{\"class\":\"" + report_class + "\"");
    if (start == std::string::npos) return {};
    return nlohmann::json::parse(text.substr(start, text.find('\n', start) - start));
  }
};

template <class M>
void append(Buffer& stream, const M& m) {
  std::array<std::uint8_t, Ubx::max_frame> out;
  const std::size_t size = encode(m, out);
  stream.insert(stream.end(), out.begin(), out.begin() + static_cast<long>(size));
}

TEST_F(Gpsdecode, ReadsOurNavPvt) {
  NavPvt m;
  m.itow = 302400200ms;
  m.date = std::chrono::year{2026} / 11 / 21;
  m.time_of_day = 12h + 34min + 56s + 250ms;
  m.time_resolved = true;
  m.fix_type = UbxFixType::three_d;
  m.fix_ok = true;
  m.satellites_used = 9;
  m.latitude_rad = radians(-36.7783451);
  m.longitude_rad = radians(-121.9017654);
  m.ellipsoidal_height_m = -31.217;
  m.mean_sea_level_height_m = 1.984;
  m.velocity_north_mps = 1.2;
  m.velocity_east_mps = -0.5;
  m.velocity_down_mps = 0.25;
  m.ground_speed_mps = 1.3;
  m.course_rad = radians(337.38014);
  m.horizontal_accuracy_m = 1.5;
  m.vertical_accuracy_m = 2.75;
  m.speed_accuracy_mps = 0.31;
  Buffer stream;
  append(stream, m);
  const auto tpv = report(stream, "TPV");
  EXPECT_EQ(tpv["mode"], 3);
  EXPECT_EQ(tpv["time"], "2026-11-21T12:34:56.250Z");
  EXPECT_NEAR(tpv["lat"], -36.7783451, 1e-9);
  EXPECT_NEAR(tpv["lon"], -121.9017654, 1e-9);
  EXPECT_NEAR(tpv["altHAE"], -31.217, 1e-9);
  EXPECT_NEAR(tpv["altMSL"], 1.984, 1e-9);
  EXPECT_NEAR(tpv["speed"], 1.3, 1e-9);
  EXPECT_NEAR(tpv["track"], 337.3801, 1e-9);
  EXPECT_NEAR(tpv["eph"], 1.5, 1e-9);
  EXPECT_NEAR(tpv["epv"], 2.75, 1e-9);
  EXPECT_NEAR(tpv["eps"], 0.31, 1e-9);
}

TEST_F(Gpsdecode, ReadsOurNavSat) {
  NavSat m;
  m.itow = 302400200ms;
  UbxSatellite gps;
  gps.number = 17;
  gps.cno_dbhz = 43;
  gps.elevation_rad = radians(52);
  gps.azimuth_rad = radians(305);
  gps.quality = 7;
  gps.used = true;
  gps.healthy = true;
  UbxSatellite galileo = gps;
  galileo.gnss = UbxGnss::galileo;
  galileo.number = 30;
  galileo.cno_dbhz = 28;
  galileo.elevation_rad = radians(9);
  galileo.azimuth_rad = radians(0);
  galileo.used = false;
  galileo.healthy = false;
  m.satellites = {gps, galileo};
  Buffer stream;
  append(stream, m);
  const auto satellites = report(stream, "SKY")["satellites"];
  ASSERT_EQ(satellites.size(), 2u);
  EXPECT_EQ(satellites[0]["gnssid"], 0);
  EXPECT_EQ(satellites[0]["svid"], 17);
  EXPECT_EQ(satellites[0]["ss"], 43);
  EXPECT_EQ(satellites[0]["el"], 52);
  EXPECT_EQ(satellites[0]["az"], 305);
  EXPECT_EQ(satellites[0]["used"], true);
  EXPECT_EQ(satellites[0]["health"], 1);
  EXPECT_EQ(satellites[1]["gnssid"], 2);
  EXPECT_EQ(satellites[1]["svid"], 30);
  EXPECT_EQ(satellites[1]["used"], false);
  EXPECT_EQ(satellites[1]["health"], 2);
}

TEST_F(Gpsdecode, ReadsOurGgaAndRmc) {
  Rmc rmc;
  rmc.valid = true;
  rmc.mode = 'A';
  rmc.date = std::chrono::year{2026} / 11 / 21;
  rmc.time_of_day = 1h + 2min + 3s;
  rmc.latitude_rad = radians(47.28523332);
  rmc.longitude_rad = radians(-8.56526500);
  rmc.speed_mps = 2.5;
  rmc.course_rad = radians(123.45);
  Gga gga;
  gga.time_of_day = rmc.time_of_day;
  gga.latitude_rad = rmc.latitude_rad;
  gga.longitude_rad = rmc.longitude_rad;
  gga.quality = 1;
  gga.satellites_used = 8;
  gga.horizontal_dop = 1.1;
  gga.mean_sea_level_height_m = -3.25;
  gga.geoid_separation_m = 47.5;
  Buffer stream;
  for (int epoch = 0; epoch < 3; ++epoch) {  // gpsd learns which sentence ends an epoch
    append(stream, rmc);
    append(stream, gga);
    *rmc.time_of_day += 1s;
    gga.time_of_day = rmc.time_of_day;
  }
  const auto tpv = report(stream, "TPV");
  EXPECT_NEAR(tpv["lat"], 47.28523332, 1e-7);
  EXPECT_NEAR(tpv["lon"], -8.56526500, 1e-7);
  EXPECT_NEAR(tpv["speed"], 2.5, 1e-3);
  EXPECT_NEAR(tpv["track"], 123.45, 1e-4);
}

}  // namespace gpsdecode_test
}  // namespace drydock::wire::testing
