// A compass on its wire aids an inertial navigation in lockstep. Only depth and heading aid it: no
// fix and no speed over ground could tell the heading.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "hil/bench/run.hpp"
#include "rig_config/load.hpp"

namespace heading_wire_test {
namespace {

using namespace drydock;

constexpr const char* sensors = R"(
[imu]
gyro_noise_degph = 0.3
accelerometer_noise_ug = 50
[depth]
pressure_noise_pa = 100
[attitude]
attitude_noise_deg = 0.5
)";

/// The start is 5 degrees wrong: the vehicle sails north.
std::string estimator(const std::string& name, const std::string& keys, const std::string& file) {
  return "[[estimator]]\nname = \"" + name +
         "\"\nkind = \"navigation\"\nimu = \"imu\"\ndepth = \"depth\"\nsensors = \"" + file +
         "\"\n" + keys +
         "[estimator.initial]\nlatitude_deg = 36\nlongitude_deg = 129\nheading_deg = 5\ndepth_m = "
         "10\n"
         "velocity_ned_mps = [10, 0, 0]\ntilt_sigma_deg = 0.001\nheading_sigma_deg = 5\n";
}

std::string device(const std::string& name, const std::string& kind, const std::string& protocol,
                   const std::string& rest, const std::string& file) {
  return "[[device]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\nprotocol = \"" + protocol +
         "\"\n" + rest + "emulate = { errors = \"" + file + "\" }\n";
}

rig_config::Rig rig(const std::string& compass) {
  const std::string file = testing::TempDir() + "heading_wire_sensors.toml";
  std::ofstream(file) << sensors;
  const std::string text =
      "[rig]\nname = \"heading\"\nseed = 1\nmission = \"../missions/leveling-straight.toml\"\n"
      "publish = false\n" +
      device("imu", "imu", "cia404-imu",
             "link = \"can:auto?name=a&bitrate=1000000\"\naddress = 1\nrate_hz = 100\n", file) +
      device("depth", "depth", "nmea2000", "link = \"can:auto?name=b\"\nrate_hz = 10\n", file) +
      device("compass", "attitude", compass,
             compass == "nmea2000" ? "link = \"can:auto?name=b\"\nrate_hz = 10\n"
                                   : "link = \"pty:compass?baud=38400\"\nrate_hz = 10\n",
             file) +
      estimator("aided", "heading = \"compass\"\n", file) + estimator("alone", "", file);
  return rig_config::load_rig_text(text, DRYDOCK_SOURCE_DIR "/rig_config/rigs/heading.toml")
      .value();
}

summary::Summary run(const rig_config::Rig& rig, double seconds) {
  testing::internal::CaptureStdout();
  bench::RunOptions options;
  options.duration_s = seconds;
  auto summary = bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return summary;
}

class HeadingWire : public testing::TestWithParam<const char*> {};

// 30 s of 10 headings with 0.5 degrees each: 0.03 degrees at the end, and 0.5 after the first.
TEST_P(HeadingWire, ACompassTakesAwayAWrongStartWithoutAnyOtherSensorOfTheHeading) {
  const auto summary = run(rig(GetParam()), 30);
  ASSERT_EQ(summary.estimators.size(), 2u);
  const auto &aided = summary.estimators[0], &alone = summary.estimators[1];
  EXPECT_NEAR(alone.navigation.value().heading_rms_deg, 5, 0.05);
  EXPECT_LT(aided.navigation.value().heading_rms_deg, 0.5);
  EXPECT_EQ(aided.rejected, 0u);
  EXPECT_NEAR(aided.nis.value(), 1, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Protocols, HeadingWire, testing::Values("nmea2000", "nmea0183"),
                         [](const auto& protocol) { return std::string(protocol.param); });

}  // namespace
}  // namespace heading_wire_test
