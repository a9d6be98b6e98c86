// The sounding rocket in lockstep: its roll estimate through wire bytes, and from the same
// measurements without a wire.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "estimators/frame/attitude.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/bench/run.hpp"
#include "hil/emulate/gnss/gnss_epoch.hpp"
#include "hil/emulate/gnss/make_sky.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/sensor/ideal.hpp"
#include "rig_config/load.hpp"

namespace drydock::bench::roll_wire_test {
namespace {

constexpr double degree = 3.14159265358979323846 / 180, seconds_flown = 60;

rig_config::Rig rocket() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/sounding-rocket.toml").value();
}

summary::Summary through_wires(const rig_config::Rig& rig) {
  testing::internal::CaptureStdout();
  RunOptions options;
  options.duration_s = seconds_flown;
  auto summary = run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return summary;
}

struct Kept final : pipeline::EstimateListener {
  void on_attitude(const pipeline::AttitudeEstimate& e) override { all.push_back(e); }
  std::vector<pipeline::AttitudeEstimate> all;
};

/// Puts the measurements of the emulated devices, at 100 Hz and 10 Hz, directly into the pipeline.
std::vector<pipeline::AttitudeEstimate> straight(const rig_config::Rig& rig) {
  const auto start = measurement::stamp_from_ns(rig.start_utc_ns);
  const auto trajectory = motion::make_trajectory(rig.mission, start);
  const auto& receiver = rig.devices.at(0);
  const auto& inertial = rig.devices.at(1);
  emulate::DeviceSetup gnss_setup{receiver, *trajectory, rig.seed,
                                  emulate::make_sky(receiver, start, rig.seed).value()};
  const emulate::DeviceSetup imu_setup{inertial, *trajectory, rig.seed, nullptr};
  emulate::GnssSensor gnss(gnss_setup);
  auto imu_errors = imu_setup.imu_errors();
  const auto antenna = sensor::mounting_of(receiver), sensor = sensor::mounting_of(inertial);

  Kept kept;
  auto pipeline = *pipeline::make_pipeline(setup::pipeline_options(rig), kept);
  for (int k = 0; k <= static_cast<int>(100 * seconds_flown); ++k) {
    const auto at = start + k * std::chrono::milliseconds{10};
    auto imu = imu_errors.apply(sensor::ideal_imu(*trajectory, at, sensor));
    imu.origin.valid_at = at;
    imu.origin.device = 1;
    pipeline.receive(imu);
    if (k % 10 != 0) continue;
    auto epoch = gnss.measure(trajectory->at(at), antenna);
    epoch.fix.origin.valid_at = epoch.sky.origin.valid_at = at;
    pipeline.receive(epoch.fix);
    pipeline.receive(epoch.sky);
  }
  pipeline.flush();
  return kept.all;
}

/// Interpolates between the two estimates around `t`, by the shorter way round.
double roll_at(const std::vector<pipeline::AttitudeEstimate>& estimates, measurement::Stamp t) {
  const auto after =
      std::ranges::find_if(estimates, [&](const auto& e) { return e.valid_at >= t; });
  const auto before = after == estimates.begin() ? after : after - 1;
  const double span = measurement::seconds(after->valid_at - before->valid_at);
  const double share = span > 0 ? measurement::seconds(t - before->valid_at) / span : 0;
  return before->roll_rad + share * frame::wrap_pi(after->roll_rad - before->roll_rad);
}

TEST(RollOnTheWire, AgreesWithTheSameFlightWithoutWiresToTheWiresResolution) {
  const auto rig = rocket();
  const auto wires = through_wires(rig);
  const auto direct = straight(rig);
  const auto start = measurement::stamp_from_ns(rig.start_utc_ns);
  ASSERT_EQ(wires.traces.size(), 1u);
  const auto& trace = wires.traces[0];
  double squares = 0, largest = 0;
  int n = 0;
  for (std::size_t i = 0; i < trace.t_s.size(); ++i) {
    if (trace.t_s[i] < 5 || trace.t_s[i] > seconds_flown - 1) continue;
    const double apart =
        frame::wrap_pi(trace.roll_deg[i] * degree -
                       roll_at(direct, start + measurement::from_seconds(trace.t_s[i])));
    squares += apart * apart;
    largest = std::max(largest, std::abs(apart));
    ++n;
  }
  ASSERT_GT(n, 500);
  // Directions are in whole degrees: .29 deg RMS each, about ten of them. Powers are in whole dB on
  // both sides, and rates are floats.
  const double rms_deg = std::sqrt(squares / n) / degree;
  RecordProperty("rms_deg", std::to_string(rms_deg));
  EXPECT_LT(rms_deg, 0.3);
  EXPECT_LT(largest / degree, 1);
}

TEST(RollOnTheWire, StaysWithinADegreeOrTwoOfTheTruthFromNothing) {
  const auto summary = through_wires(rocket());
  ASSERT_EQ(summary.estimators.size(), 1u);
  EXPECT_EQ(summary.estimators[0].kind, "roll");
  ASSERT_TRUE(summary.estimators[0].after_10_s);
  EXPECT_LT(summary.estimators[0].after_10_s->roll_rms_deg, 1.5);
  EXPECT_LT(summary.estimators[0].after_10_s->pitch_rms_deg, 1);
  EXPECT_LT(summary.estimators[0].after_10_s->nees_mean, 3);
}

TEST(RollOnTheWire, Nmea0183DoesItToo) {
  auto rig = rocket();
  rig.devices.at(0).protocol = "nmea0183";
  const auto summary = through_wires(rig);
  ASSERT_TRUE(summary.estimators.at(0).after_10_s);
  EXPECT_LT(summary.estimators[0].after_10_s->roll_rms_deg, 1.5);
  EXPECT_LT(summary.estimators[0].after_10_s->pitch_rms_deg, 1.5);
  EXPECT_GT(summary.estimators[0].estimates, 5500u);
}

}  // namespace
}  // namespace drydock::bench::roll_wire_test
