#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "drivers/measurement/units.hpp"
#include "hil/bench/run.hpp"
#include "hil/twin/twin.hpp"
#include "rig_config/load.hpp"

namespace drydock::twin {
namespace {

namespace fs = std::filesystem;

/// The rig of the velocity paper has an IMU in its track. Its file states 0.0004 deg/sqrt(h), which
/// is 0.24 deg/h for each sample at 100 Hz, and 4 ug/sqrt(Hz), which is 40 ug.
TEST(InertialTwin, FeelsWhatTheRecordedImuFelt) {
  const auto folder = fs::temp_directory_path() / ("inertial-twin-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  bench::RunOptions run;
  run.duration_s = 60;
  run.quiet = true;
  run.record.path = (folder / "dive.mcap").string();
  bench::run_lockstep(
      rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/velocity-paper.toml").value(), run);
  TwinOptions options;
  options.source.source.capture = run.record.path;
  options.folder = (folder / "twin").string();
  const auto outcome = make_twin(options);
  EXPECT_TRUE(outcome.recorded.inertial);
  EXPECT_DOUBLE_EQ(outcome.every_s, 0.1);
  const auto& imu = outcome.devices.at(0);
  ASSERT_EQ(imu.kind, rig_config::DeviceKind::imu);
  const std::array stated_white{0.24 * units::degree_per_hour, 40 * units::micro_g};
  for (std::size_t place = 0; place < 2; ++place)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& recorded = imu.recorded.quantities.at(place).axes.at(axis).value();
      const auto& twin = imu.twin.quantities.at(place).axes.at(axis).value();
      EXPECT_NEAR(recorded.white / stated_white[place], 1, 0.05) << place << " " << axis;
      EXPECT_NEAR(twin.white / recorded.white, 1, 0.05) << place << " " << axis;
      EXPECT_NEAR(twin.sigma / recorded.sigma, 1, 0.1) << place << " " << axis;
    }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace drydock::twin
