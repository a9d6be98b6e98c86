// The mixing paper's mission twice: measurements go directly into the filters, and the same
// measurements go through emulated devices, wire bytes, drivers and the pipeline in lockstep.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "estimators/mixing/mixing_filter.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/bench/run.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/sensor/ideal.hpp"
#include "hil/sensor/imu_errors.hpp"
#include "rig_config/load.hpp"

namespace mixing_wire_test {
namespace {

using namespace drydock;

constexpr double degree = std::numbers::pi / 180, seconds = 160;  // dive, circle, acceleration
constexpr int imu_hz = 100, samples_per_speed = 10;

rig_config::Rig mixing_rig() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/mixing-paper.toml").value();
}

/// The sensors have the constants of Table 5 and no noise, so the two ways differ only by the wire.
rig_config::Rig without_noise(rig_config::Rig rig) {
  for (auto& device : rig.devices)
    device.emulate.primary.noise = device.emulate.secondary.noise = {};
  return rig;
}

summary::Summary run(const rig_config::Rig& rig, double duration_s) {
  testing::internal::CaptureStdout();
  bench::RunOptions options;
  options.duration_s = duration_s;
  auto summary = bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return summary;
}

/// The sensors' values at each hundredth of a second.
struct Readings {
  std::vector<measurement::ImuSample> imu;
  std::vector<double> speed_mps;  ///< one for every tenth IMU sample
};

Readings readings_of(const rig_config::Rig& rig) {
  const auto start = measurement::stamp_from_ns(rig.start_utc_ns);
  const auto trajectory = motion::make_trajectory(rig.mission, start);
  const auto& unit = rig.devices.at(0);
  const auto& log = rig.devices.at(1);
  sensor::ImuErrors imu_errors(unit.emulate, unit.rate_hz, rig.seed, unit.name);
  sensor::ErrorModel log_errors(log.emulate.primary, log.rate_hz,
                                {rig.seed, log.name, "primary", log.emulate.fixed_bias});
  Readings readings;
  for (int k = 0; k < seconds * imu_hz; ++k) {
    const auto at = start + std::chrono::milliseconds{10} * k;
    readings.imu.push_back(imu_errors.apply(sensor::ideal_imu(*trajectory, at, {})));
    if (k % samples_per_speed == 0)
      readings.speed_mps.push_back(
          log_errors.apply(*sensor::ideal_log(*trajectory, at, {}).longitudinal_mps, at));
  }
  return readings;
}

struct Attitude {
  double roll_deg, pitch_deg;
};

/// The attitude after every IMU sample from `first` on.
std::vector<Attitude> straight_into(const mixing::MixingOptions& options, const Readings& readings,
                                    std::size_t first) {
  mixing::MixingFilter filter(options);
  double speed = readings.speed_mps[first / samples_per_speed];
  const auto* last = &readings.imu[first];
  filter.start(last->specific_force, last->angular_rate, speed);
  std::vector<Attitude> attitudes(1, {filter.roll() / degree, filter.pitch() / degree});
  for (std::size_t k = first + 1; k < readings.imu.size(); ++k) {
    const auto& next = readings.imu[k];
    filter.step((last->specific_force + next.specific_force) / 2,
                (last->angular_rate + next.angular_rate) / 2, speed, 1.0 / imu_hz);
    attitudes.push_back({filter.roll() / degree, filter.pitch() / degree});
    if (k % samples_per_speed == 0) speed = readings.speed_mps[k / samples_per_speed];
    last = &next;
  }
  return attitudes;
}

TEST(MixingOnTheWire, EveryTypeAgreesWithItsMeasurementsToTheWiresResolution) {
  const auto rig = without_noise(mixing_rig());
  const auto summary = run(rig, seconds);
  EXPECT_TRUE(summary.all_streaming());
  const auto readings = readings_of(rig);
  const auto options = setup::pipeline_options(rig);
  for (std::size_t i = 0; i < rig.estimators.size(); ++i) {
    const auto& wire = summary.traces.at(i);
    ASSERT_GT(wire.t_s.size(), 500U);
    const auto sample = [&](double t) { return static_cast<std::size_t>(std::lround(t * imu_hz)); };
    const std::size_t first = sample(wire.t_s.front());
    const auto direct = straight_into(
        std::get<pipeline::MixingOptions>(options.estimators[i].kind).filter, readings, first);
    double roll_deg = 0, pitch_deg = 0;
    for (std::size_t k = 0; k < wire.t_s.size(); ++k) {
      const Attitude& there = direct.at(sample(wire.t_s[k]) - first);
      roll_deg = std::max(roll_deg, std::abs(there.roll_deg - wire.roll_deg[k]));
      pitch_deg = std::max(pitch_deg, std::abs(there.pitch_deg - wire.pitch_deg[k]));
    }
    // The log has a resolution of .01 knot: in a turn of 0.13 rad/s that is 0.004 deg of roll.
    EXPECT_LT(roll_deg, 0.01) << rig.estimators[i].name;
    EXPECT_LT(pitch_deg, 0.01) << rig.estimators[i].name;
  }
}

TEST(MixingOnTheWire, TheWholeMissionStaysWithinThePapersErrors) {
  const auto summary = run(mixing_rig(), 600);
  EXPECT_TRUE(summary.all_streaming());
  ASSERT_EQ(summary.estimators.size(), 4U);
  const auto& compensated = *summary.estimators[0].whole_run;
  const auto& type1 = *summary.estimators[1].whole_run;
  EXPECT_LT(compensated.roll_rms_deg, 0.5);  // one run: three times 0.14 deg, plus the log's
                                             // rounding in the turn
  EXPECT_LT(compensated.pitch_rms_deg, 0.5);
  EXPECT_LT(compensated.nees_mean, 9);
  EXPECT_GT(type1.pitch_max_deg, 0.5);
}

}  // namespace
}  // namespace mixing_wire_test
