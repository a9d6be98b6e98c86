// The captures of several sensors, read by a rig: a track and a twin.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "drivers/recordings/export/exporter.hpp"
#include "hil/bench/run.hpp"
#include "hil/twin/twin.hpp"
#include "rig_config/load.hpp"

namespace drydock::twin {
namespace captures_test {

namespace fs = std::filesystem;
constexpr const char* demo = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";

/// 75 s of the demo rig, recorded: the bus as a candump log, each line as its bytes alone, and all
/// links in one pcapng.
class CapturesOfARun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::temp_directory_path() / ("captures-test-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    bench::RunOptions run;
    run.duration_s = 75;
    run.quiet = true;
    run.record.path = file("dive.mcap");
    bench::run_lockstep(rig_config::load_rig(demo).value(), run);
    write(exporting::Format::candump, "can.log");
    write(exporting::Format::pcapng, "all.pcapng");
    write(exporting::Format::raw, "lines");
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static std::string file(const std::string& name) { return (folder_ / name).string(); }
  static void write(exporting::Format format, const std::string& name) {
    ASSERT_TRUE(exporting::export_recording(file("dive.mcap"), {}, format,
                                            {.path = file(name), .overwrite = true},
                                            [](double) { return true; }));
  }
  static track::TrackOptions of(std::vector<replay::RigCaptures::File> captures) {
    track::TrackOptions options;
    options.captures = std::move(captures);
    options.rig = demo;
    return options;
  }
  static track::Outcome tracked(const track::TrackOptions& options) {
    return track::smoothed(track::gather(options), track::Model::level, {});
  }

  static inline fs::path folder_;
};

TEST_F(CapturesOfARun, MakeTheTrackThatTheirRecordingMakes) {
  track::TrackOptions recording;
  recording.source.capture = file("dive.mcap");
  const auto expected = tracked(recording), found = tracked(of({{file("all.pcapng")}}));
  ASSERT_EQ(found.sensors.size(), expected.sensors.size());
  for (std::size_t i = 0; i < found.sensors.size(); ++i)
    EXPECT_EQ(found.sensors[i].readings, expected.sensors[i].readings) << i;
  ASSERT_EQ(found.track.smoothed.size(), expected.track.smoothed.size());
  const auto& at = found.track.smoothed.back().position;
  const auto& wanted = expected.track.smoothed.back().position;
  EXPECT_NEAR(at.latitude_rad, wanted.latitude_rad, 1e-10);  // 0.6 mm
  EXPECT_NEAR(at.longitude_rad, wanted.longitude_rad, 1e-10);
  EXPECT_NEAR(at.height_m, wanted.height_m, 1e-3);
}

/// demo.toml: 75 s with 5 ensembles and 10 depths a second.
TEST_F(CapturesOfARun, OfALineAndOfABusStandBesideEachOther) {
  const auto gathered = track::gather(of({{file("lines/dvl.bin"), "dvl"}, {file("can.log")}}));
  const auto count = [&](smoothing::Quantity quantity) {
    return std::ranges::count(gathered.dive.readings, quantity, &smoothing::Reading::quantity);
  };
  EXPECT_NEAR(static_cast<double>(count(smoothing::Quantity::bottom)), 375, 4);
  EXPECT_NEAR(static_cast<double>(count(smoothing::Quantity::depth)), 750, 80);
  EXPECT_EQ(count(smoothing::Quantity::fix), 0);
}

/// As `replay` does with the same words.
TEST_F(CapturesOfARun, ThatSeveralFilesMayBeOfOneDeviceAreWrongUsage) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(track::track(of({{file("all.pcapng")}, {file("can.log")}}), stdout, stderr), 2);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("imu=FILE names the file"),
            std::string::npos);
}

TEST_F(CapturesOfARun, MakeATwinOfTheirSensorsAlone) {
  TwinOptions options;
  options.source = of({{file("lines/gnss.bin")}, {file("lines/dvl.bin")}});
  options.folder = file("twin");
  const auto outcome = make_twin(options);
  ASSERT_EQ(outcome.devices.size(), 2U);
  EXPECT_EQ(outcome.devices[0].name, "dvl");
  EXPECT_EQ(outcome.devices[1].name, "gnss");
  for (const auto& device : outcome.devices)
    EXPECT_NEAR(device.twin.timing.rate_hz, 5, 0.05) << device.name;
}

}  // namespace captures_test
}  // namespace drydock::twin
