// The user of a rig is told which measurements the estimators could not use.
#include <gtest/gtest.h>

#include <limits>

#include "estimators/setup/rig_pipeline.hpp"

namespace {

using namespace drydock;
using std::chrono::milliseconds;
using Notes = std::vector<std::string>;

struct Ignore final : pipeline::EstimateListener {
  void on_attitude(const pipeline::AttitudeEstimate&) override {}
};

rig_config::Rig still_rig() {
  rig_config::Rig rig;
  rig.devices.resize(1);
  rig.devices[0].name = "imu";
  rig.estimators.resize(1);
  rig.estimators[0].imu = "imu";
  rig.estimators[0].kind = rig_config::LevelingConfig{.stationary = true, .log = {}, .start = {}};
  rig.reorder_window_s = 0;
  return rig;
}

measurement::ImuSample sample(int at_ms, double down_mps2 = -9.8) {
  measurement::ImuSample imu;
  imu.origin.valid_at = measurement::Stamp{milliseconds{at_ms}};
  imu.specific_force = {0, 0, down_mps2};
  return imu;
}

Notes notes_after(const std::vector<measurement::Measurement>& measurements,
                  const pipeline::PipelineOptions& options) {
  Ignore nobody;
  auto pipeline = *pipeline::make_pipeline(options, nobody);
  for (const auto& m : measurements) pipeline.receive(m);
  return setup::pipeline_notes(still_rig(), pipeline);
}

TEST(PipelineNotes, AreEmptyWhenEveryMeasurementWasUsed) {
  EXPECT_EQ(notes_after({sample(0), sample(10)}, setup::pipeline_options(still_rig())), Notes{});
}

TEST(PipelineNotes, NameTheDeviceWithWhatCameLateAndWhatWasRefused) {
  const auto no_number = sample(30, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(notes_after({sample(0), sample(20), sample(10), no_number},
                        setup::pipeline_options(still_rig())),
            Notes{"imu: of 4 measurements 1 too late for the estimators, 1 refused"});
}

TEST(PipelineNotes, TellWhatAnEstimatorKeptOutsideItsGate) {
  auto rig = still_rig();
  rig.devices.resize(2);
  rig.devices[1].name = "log";
  rig.estimators[0].name = "attitude";
  rig.estimators[0].kind = rig_config::LevelingConfig{.log = "log", .start = {}};
  Ignore nobody;
  auto pipeline = *pipeline::make_pipeline(setup::pipeline_options(rig), nobody);
  measurement::WaterSpeed speed;
  speed.origin.device = 1;
  for (int ms = 0; ms <= 10'000; ms += 10) {
    speed.origin.valid_at = measurement::Stamp{milliseconds{ms}};
    speed.longitudinal_mps = ms == 9000 || ms == 9500 ? 50 : 2;
    if (ms % 500 == 0) pipeline.receive(speed);
    pipeline.receive(sample(ms));
  }
  EXPECT_EQ(setup::pipeline_notes(rig, pipeline), Notes{"attitude: 2 values outside its gate"});
}

TEST(PipelineNotes, TellOfABufferThatIsTooSmallForTheWindow) {
  auto options = setup::pipeline_options(still_rig());
  options.reorder_window = milliseconds{200};
  options.reorder_capacity = 2;
  EXPECT_EQ(notes_after({sample(0), sample(10), sample(20)}, options),
            Notes{"reorder buffer full: 1 measurements used before their turn"});
}

}  // namespace
