#include "hil/twin/twin.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "hil/bench/run.hpp"
#include "rig_config/load.hpp"

namespace drydock::twin {
namespace {

namespace fs = std::filesystem;

/// 75 s of the demo rig: S path, turn, dive. Its twin sails them again.
class TwinOfARun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::temp_directory_path() / ("twin-test-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    bench::RunOptions run;
    run.duration_s = 75;
    run.quiet = true;
    run.record.path = recording();
    bench::run_lockstep(
        rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value(), run);
    outcome_ = make_twin(options());
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static std::string recording() { return (folder_ / "dive.mcap").string(); }
  static TwinOptions options() {
    TwinOptions options;
    options.source.source.capture = recording();
    options.folder = (folder_ / "twin").string();
    return options;
  }
  static const DeviceBeside& device(const std::string& name) {
    for (const auto& one : outcome_.devices)
      if (one.name == name) return one;
    throw std::runtime_error("no device " + name);
  }

  static inline fs::path folder_;
  static inline TwinOutcome outcome_;
};

TEST_F(TwinOfARun, SendsAtTheRatesOfTheRecording) {
  ASSERT_EQ(outcome_.devices.size(), 6u);
  for (const auto& one : outcome_.devices) {
    SCOPED_TRACE(one.name);
    EXPECT_NEAR(one.twin.timing.rate_hz / one.recorded.timing.rate_hz, 1, 0.01);
    EXPECT_NEAR(static_cast<double>(one.twin.timing.samples) /
                    static_cast<double>(one.recorded.timing.samples),
                1, 0.03);
  }
  EXPECT_NEAR(device("dvl").twin.timing.rate_hz, 5, 0.05);  // of demo.toml
}

/// The figures are those of rig_config/rigs/demo.toml.
TEST_F(TwinOfARun, FindsTheNoiseThatTheRigFileStates) {
  const auto white = [](const DeviceStatistics& statistics, std::size_t axis) {
    return statistics.quantities.at(0).axes.at(axis).value().white;
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(white(device("dvl").recorded, axis), 0.01, 0.002);
    EXPECT_NEAR(white(device("gnss").recorded, axis), 1.5, 0.3);
  }
  EXPECT_NEAR(white(device("depth").recorded, 0), 100, 15);
}

TEST_F(TwinOfARun, HasTheNoiseOfTheRecording) {
  for (const char* name : {"dvl", "emlog", "gnss", "depth", "imu"}) {
    SCOPED_TRACE(name);
    const auto& one = device(name);
    for (std::size_t place = 0; place < one.recorded.quantities.size(); ++place)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& recorded = one.recorded.quantities[place].axes.at(axis);
        if (!recorded) continue;
        const auto& twin = one.twin.quantities.at(place).axes.at(axis);
        ASSERT_TRUE(twin);
        EXPECT_NEAR(twin->white / recorded->white, 1, 0.25) << place << " " << axis;
      }
  }
}

TEST_F(TwinOfARun, SurprisesTheFilterAsMuch) {
  ASSERT_TRUE(outcome_.sailed);
  for (const auto& recorded : outcome_.recorded.sensors)
    for (const auto& twin : outcome_.sailed->sensors) {
      if (twin.device != recorded.device || twin.quantity != recorded.quantity) continue;
      SCOPED_TRACE(recorded.device);
      EXPECT_NEAR(twin.rms / recorded.rms, 1, 0.3);
    }
}

TEST_F(TwinOfARun, IsARigAsAnyOther) {
  const auto rig = rig_config::load_rig((folder_ / "twin" / "rig.toml").string());
  ASSERT_TRUE(rig) << to_string(rig.error().front());
  EXPECT_TRUE(rig->mission.track);
  bench::RunOptions run;
  run.quiet = true;
  run.lockstep = true;
  const auto summary = bench::run_lockstep(*rig, run);
  EXPECT_NEAR(summary.duration_s, 75, 1);
  EXPECT_TRUE(summary.all_streaming());
  // The leveling filter of the demo rig: within the bounds that its rig file expects.
  EXPECT_LT(summary.estimators.at(0).whole_run->roll_rms_deg, 2);
}

TEST_F(TwinOfARun, ShowsBothSidesAsTextJsonAndAPage) {
  auto again = options();
  EXPECT_EQ(twin(again, stdout, stderr), 1) << "the folder is not empty";
  EXPECT_THAT(to_text(outcome_), testing::HasSubstr("Errors against the track"));
  const auto json = nlohmann::json::parse(to_json(outcome_));
  EXPECT_EQ(json["devices"].size(), 6u);
  EXPECT_GT(json["innovations"]["twin"].size(), 2u);
  EXPECT_THAT(to_html(outcome_), testing::HasSubstr("<html"));
}

}  // namespace
}  // namespace drydock::twin
