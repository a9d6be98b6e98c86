// A recorded run goes through another rig's drivers and estimators, and is judged like a run.
#include "hil/replay/rigs/other_rig.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "hil/replay/recorded_trajectory.hpp"
#include "tests/hil/replay/recorded_run.hpp"

namespace other_rig_test {

using namespace recorded_run;
using testing::HasSubstr;

class AnotherRig : public ReplayOfARun {
 protected:
  /// The demo rig, with its text changed.
  static std::string rig_with(const std::vector<std::pair<std::string, std::string>>& changes) {
    std::ifstream in(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml");
    std::string text{std::istreambuf_iterator<char>(in), {}};
    for (const auto& [from, to] : changes) {
      const auto at = text.find(from);
      EXPECT_NE(at, text.npos) << from;
      text.replace(at, from.size(), to);
    }
    for (auto at = text.find("\"../"); at != text.npos; at = text.find("\"../"))
      text.replace(at + 1, 2, DRYDOCK_SOURCE_DIR "/rig_config");
    const std::string path = file("other.toml");
    std::ofstream(path) << text;
    return path;
  }

  static RigReplayOptions through(const std::string& rig) {
    auto options = quiet("run.mcap");
    options.rig = rig;
    return options;
  }
};

TEST_F(AnotherRig, OfTheSameTextHasTheErrorsOfTheRun) {
  auto options = through(rig_with({}));
  options.json = file("summary.json");
  const auto result = replayed(options);
  EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
  std::ifstream in(options.json);
  const auto summary = nlohmann::json::parse(in);
  for (const auto& device : summary.at("devices")) EXPECT_EQ(device.at("state"), "streaming");
  ASSERT_EQ(summary.at("estimators").size(), 1u);
  const auto& whole = summary.at("estimators")[0].at("whole_run");
  const auto& truth = *summary_.estimators.at(0).whole_run;
  // The recorded truth is interpolated between times 40 ms apart.
  EXPECT_NEAR(whole.at("roll_rms_deg").get<double>(), truth.roll_rms_deg, 0.002);
  EXPECT_NEAR(whole.at("pitch_rms_deg").get<double>(), truth.pitch_rms_deg, 0.002);
}

TEST_F(AnotherRig, SaysWhatDoesNotFit) {
  const auto rig = rig_with(
      {{"name = \"gnss\"", "name = \"satellites\""}, {"protocol = \"pd0\"", "protocol = \"pd4\""}});
  const auto result = replayed(through(rig));
  EXPECT_THAT(result.err, HasSubstr("satellites: left out"));
  EXPECT_THAT(result.err, HasSubstr("gnss: only in the recording"));
  EXPECT_THAT(result.err, HasSubstr("dvl: read as pd4, recorded as pd0"));
  EXPECT_THAT(result.out, HasSubstr("dvl: 0 measurements"));
}

TEST_F(AnotherRig, WithoutAnyRecordedDeviceIsRefused) {
  std::ofstream(file("stranger.toml"))
      << "[rig]\nname = \"stranger\"\n[[device]]\nname = \"sonar\"\nkind = \"dvl\"\n"
         "protocol = \"pd0\"\nlink = \"serial:/dev/ttyUSB0?baud=9600\"\nrate_hz = 1\n";
  const auto result = replayed(through(file("stranger.toml")));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("no device of"));
}

TEST_F(AnotherRig, FailsWhereAnExpectationIsNotMet) {
  auto options = quiet("run.mcap");
  options.junit = file("verdicts.xml");
  std::ofstream(file("strict.toml"), std::ios::app)
      << std::ifstream(rig_with({})).rdbuf()
      << "\n[[expect]]\ndevice = \"dvl\"\nrate_hz = [9, 11]\n";
  options.rig = file("strict.toml");
  EXPECT_EQ(replayed(options).exit_code, 1);
  std::ifstream in(options.junit);
  const std::string junit{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(junit, HasSubstr("<failure"));
}

/// Half way between two times of a steady turn.
TEST(RecordedTrajectory, InterpolatesPositionVelocityAndAttitude) {
  std::vector<host::Estimate> truth(2);
  for (int i = 0; i < 2; ++i) {
    auto& navigation = truth[static_cast<std::size_t>(i)].navigation.emplace();
    navigation.valid_at = measurement::Stamp{} + std::chrono::seconds{i};
    navigation.latitude_rad = 0.5 + 1e-6 * i;
    navigation.longitude_rad = i == 0 ? 3.141592 : -3.141592;  // over the date line
    navigation.height_m = -10 - 2 * i;
    navigation.velocity_ned = {2.0 * i, 0, 0};
    navigation.body_to_ned = Eigen::AngleAxisd(0.2 * i, Eigen::Vector3d::UnitZ());
  }
  const RecordedTrajectory motion(truth);
  const auto middle = motion.at(measurement::Stamp{} + std::chrono::milliseconds{500});
  EXPECT_NEAR(middle.latitude_rad, 0.5 + 0.5e-6, 1e-12);
  EXPECT_NEAR(std::abs(std::remainder(middle.longitude_rad, 2 * 3.14159265358979)),
              3.14159265358979, 1e-6);
  EXPECT_NEAR(middle.height_m, -11, 1e-9);
  EXPECT_NEAR(middle.velocity_ned.x(), 1, 1e-9);
  EXPECT_NEAR(middle.yaw_rad, 0.1, 1e-9);
  EXPECT_NEAR(middle.velocity_body.x(), std::cos(0.1), 1e-9);
}

}  // namespace other_rig_test
