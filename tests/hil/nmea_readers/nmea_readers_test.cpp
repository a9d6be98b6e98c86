#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "hil/sensor/sky.hpp"
#include "rig_config/device_description/load_description.hpp"
#include "tests/hil/emulate/bench.hpp"
#include "tests/npm/node.hpp"

/// pynmea2 and nmea-simple read the sentences of emulated devices. Their values must be the truth,
/// within half of the last digit that the sentence has.
namespace drydock::peer {
namespace nmea_readers_test {

using emulate::degree;
using nlohmann::json;
using rig_config::DeviceKind;

constexpr double knot_mps = 1852.0 / 3600, kmph_mps = 1 / 3.6;
constexpr double minute_deg = 1.0 / 60;

bool has_pynmea2() { return std::system("/usr/bin/python3 -c 'import pynmea2' 2>/dev/null") == 0; }

json read_by_pynmea2(const std::string& sentences) {
  return test::run_for_json("/usr/bin/python3 " DRYDOCK_SOURCE_DIR
                            "/tests/hil/nmea_readers/read_by_pynmea2.py",
                            sentences);
}

json read_by_nmea_simple(const std::string& sentences) {
  return test::run_node("tests/hil/nmea_readers/read_by_nmea_simple.cjs", {}, sentences);
}

std::string sentences_of(const rig_config::DeviceConfig& config, const motion::Truth& truth) {
  const emulate::Frozen trajectory(truth);
  const auto bytes = emulate::record(config, trajectory, 2).all_bytes();
  return {bytes.begin(), bytes.end()};
}

std::string of_receiver() {
  return sentences_of(emulate::device(DeviceKind::gnss, "nmea0183"), emulate::at_the_surface());
}
std::string of_log() {
  return sentences_of(emulate::device(DeviceKind::emlog, "nmea0183"), emulate::under_way());
}
std::string of_compass(bool magnetic) {
  auto config = emulate::device(DeviceKind::attitude, "nmea0183");
  config.emulate.compass.magnetic = magnetic;
  config.emulate.compass.variation_rad = 9 * degree;
  return sentences_of(config, emulate::under_way());
}
std::string of_sounder() {
  auto config = emulate::device(DeviceKind::depth, "nmea-depth.toml");
  config.description = rig_config::find_description("nmea-depth.toml", "").value();
  return sentences_of(config, emulate::under_way());
}

/// What a reader found in the last sentence of a kind.
struct Read {
  json values;
  void near(const char* key, double truth, double tolerance) const {
    ASSERT_TRUE(values.contains(key)) << key << " of " << values;
    ASSERT_TRUE(values[key].is_number()) << key << " of " << values;
    EXPECT_NEAR(values[key].get<double>(), truth, tolerance) << key << " of " << values;
  }
};

Read last(const json& read, const std::string& sentence) {
  Read found;
  if (!read.is_array()) return found;
  for (const json& one : read)
    if (one.at("sentence") == sentence) found.values = one;
  EXPECT_FALSE(found.values.is_null()) << "no " << sentence << " in " << read;
  return found;
}

double course_deg(const motion::Truth& truth) {
  const double course = std::atan2(truth.velocity_ned.y(), truth.velocity_ned.x()) / degree;
  return course < 0 ? course + 360 : course;
}

void expect_receiver(const json& read) {
  auto truth = emulate::at_the_surface();
  truth.at = emulate::at_s(2);
  const double latitude = truth.latitude_rad / degree, longitude = truth.longitude_rad / degree;
  const double speed_mps = truth.velocity_ned.head<2>().norm();
  const double now_s = measurement::seconds(emulate::at_s(2).time_since_epoch());
  const double second_of_day = std::fmod(now_s, 86400);
  const auto gga = last(read, "GGA"), rmc = last(read, "RMC"), vtg = last(read, "VTG");
  for (const auto* place : {&gga, &rmc}) {
    place->near("latitude_deg", latitude, 0.51e-5 * minute_deg);
    place->near("longitude_deg", longitude, 0.51e-5 * minute_deg);
  }
  gga.near("second_of_day", second_of_day, 0.006);
  const double height_m =
      gga.values["altitude_m"].get<double>() + gga.values["separation_m"].get<double>();
  EXPECT_NEAR(height_m, truth.height_m, 0.011) << gga.values;
  gga.near("quality", 1, 0);
  const auto& sky = sensor::ideal_sky(truth, false).satellites;
  gga.near("satellites",
           static_cast<double>(
               std::ranges::count_if(sky, [](const auto& satellite) { return satellite.used; })),
           0);
  last(read, "GSV").near("satellites_in_view", static_cast<double>(sky.size()), 0);
  last(read, "GSA").near("fix", 3, 0);
  rmc.near("utc_s", now_s, 0.006);
  for (const auto* motion : {&rmc, &vtg}) {
    motion->near("speed_kn", speed_mps / knot_mps, 0.51e-3);
    motion->near("course_deg", course_deg(truth), 0.51e-2);
  }
  vtg.near("speed_kmph", speed_mps / kmph_mps, 0.51e-3);
}

void expect_headings(const json& in_truth, const json& magnetic) {
  last(in_truth, "HDT").near("heading_deg", 290, 0.051);
  last(magnetic, "HDM").near("heading_deg", 281, 0.051);
  const auto hdg = last(magnetic, "HDG");
  hdg.near("heading_deg", 281, 0.051);
  hdg.near("variation_deg", 9, 0.051);
  EXPECT_EQ(hdg.values["variation_to"], "E");
}

void expect_depth_below_transducer(const json& read) {
  const auto dbt = last(read, "DBT");
  dbt.near("depth_m", 30, 0.051);
  dbt.near("depth_ft", 30 / 0.3048, 0.051);
  dbt.near("depth_fathoms", 30 / 1.8288, 0.051);
}

void expect_water_speed(const json& read) {
  const auto vhw = last(read, "VHW");
  vhw.near("speed_kn", 2 / knot_mps, 0.51e-3);
  vhw.near("speed_kmph", 2 / kmph_mps, 0.51e-3);
}

class ByPynmea2 : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_pynmea2()) GTEST_SKIP() << "pynmea2 is not installed (package python3-nmea2)";
  }
};

TEST_F(ByPynmea2, AReceiversSentencesHaveTheTruth) {
  expect_receiver(read_by_pynmea2(of_receiver()));
}

TEST_F(ByPynmea2, ALogsSentencesHaveTheTruth) {
  const auto read = read_by_pynmea2(of_log());
  const auto vbw = last(read, "VBW");
  vbw.near("ahead_kn", 2 / knot_mps, 0.51e-3);
  vbw.near("starboard_kn", 0.123 / knot_mps, 0.51e-3);
  expect_water_speed(read);
  last(read, "VLW").near("distance_nmi", 4.0 / 1852, 0.51e-3 + 2.0 / 1852);
}

TEST_F(ByPynmea2, ACompassesSentencesHaveTheTruth) {
  expect_headings(read_by_pynmea2(of_compass(false)), read_by_pynmea2(of_compass(true)));
}

TEST_F(ByPynmea2, AnEchoSoundersSentencesHaveTheTruth) {
  const auto read = read_by_pynmea2(of_sounder());
  expect_depth_below_transducer(read);
  const auto dpt = last(read, "DPT");
  dpt.near("depth_m", 30, 0.051);
  dpt.near("offset_m", 0, 0);
  last(read, "MTW").near("temperature_c", 10, 0.051);
}

TEST(ByNmeaSimple, AReceiversSentencesHaveTheTruth) {
  DRYDOCK_NEEDS_NODE();
  expect_receiver(read_by_nmea_simple(of_receiver()));
}

TEST(ByNmeaSimple, LogCompassAndEchoSounderHaveTheTruth) {
  DRYDOCK_NEEDS_NODE();
  expect_water_speed(read_by_nmea_simple(of_log()));
  expect_headings(read_by_nmea_simple(of_compass(false)), read_by_nmea_simple(of_compass(true)));
  expect_depth_below_transducer(read_by_nmea_simple(of_sounder()));
}

}  // namespace nmea_readers_test
}  // namespace drydock::peer
