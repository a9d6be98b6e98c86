// One mission twice: measurements go directly into the filters as in the leveling study, and the
// same measurements go through emulated devices, wire bytes, drivers and the pipeline in lockstep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimators/leveling/any_leveling_filter.hpp"
#include "hil/bench/run.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/sensor/errors.hpp"
#include "hil/sensor/ideal.hpp"
#include "hil/sensor/imu_errors.hpp"
#include "rig_config/load.hpp"

namespace leveling_wire_test {
namespace {

using namespace drydock;
using measurement::Stamp;
using Kind = rig_config::DeviceKind;

constexpr double degree = std::numbers::pi / 180;
constexpr double seconds = 60;
constexpr int imu_hz = 100, samples_per_speed = 50, first_sample = 1;

/// The demo's IMU (CiA 404, REAL32, CAN) and log (NMEA 0183, 4800 baud) with the biases of Table 1
/// and without noise. The two ways then differ only by the wire.
rig_config::LevelingConfig& leveling_of(rig_config::EstimatorConfig& estimator) {
  return std::get<rig_config::LevelingConfig>(estimator.kind);
}

rig_config::Rig two_sensors() {
  auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
  rig.expects.clear();
  std::erase_if(rig.devices,
                [](const auto& d) { return d.kind != Kind::imu && d.kind != Kind::emlog; });
  for (auto& device : rig.devices) {
    device.mounting_rad = {};
    device.lever_arm_m = {};
    device.emulate.fixed_bias = true;
    device.emulate.primary.noise = device.emulate.secondary.noise = {};
  }
  auto& robust = rig.estimators.at(0);
  leveling_of(robust).filter = rig_config::LevelingFilter::robust;
  leveling_of(robust).start.heading_rad = 0;
  auto augmented = robust, paper = robust;
  augmented.name = "augmented";
  leveling_of(augmented).filter = rig_config::LevelingFilter::augmented;
  paper.name = "paper";
  leveling_of(paper).filter = rig_config::LevelingFilter::paper;
  leveling_of(paper).start.accelerometer = false;
  rig.estimators.push_back(augmented);
  rig.estimators.push_back(paper);
  return rig;
}

const rig_config::DeviceConfig& device_of(const rig_config::Rig& rig, Kind kind) {
  return *std::ranges::find(rig.devices, kind, &rig_config::DeviceConfig::kind);
}

struct Attitude {
  double t_s, roll_deg, pitch_deg;
};

/// Without a wire: the filter gets the sensors' values directly.
std::vector<Attitude> straight_into(leveling::FilterKind kind, const rig_config::Rig& rig) {
  const Stamp start = measurement::stamp_from_ns(rig.start_utc_ns);
  const auto trajectory = motion::make_trajectory(rig.mission, start);
  const auto& unit = device_of(rig, Kind::imu);
  const auto& em_log = device_of(rig, Kind::emlog);
  sensor::ImuErrors imu_errors(unit.emulate, imu_hz, rig.seed, unit.name);
  sensor::ErrorModel log_errors(em_log.emulate.primary, em_log.rate_hz,
                                {rig.seed, em_log.name, "primary", true});
  const auto at = [&](int k) { return start + std::chrono::milliseconds{1000 / imu_hz} * k; };
  const auto imu = [&](int k) {
    return imu_errors.apply(sensor::ideal_imu(*trajectory, at(k), {}));
  };
  const auto speed = [&](int k) {
    return log_errors.apply(*sensor::ideal_log(*trajectory, at(k), {}).longitudinal_mps, at(k));
  };

  auto options = leveling::options_for(kind);
  const auto& start = std::get<rig_config::LevelingConfig>(rig.estimators.at(0).kind).start;
  options.latitude_rad = start.latitude_rad;
  options.heading_rad = start.heading_rad;
  auto any = leveling::make_filter(kind, options);
  std::vector<Attitude> attitudes;
  std::visit(
      [&](auto& filter) {
        auto last = imu(first_sample);
        filter.start(last.specific_force, last.angular_rate, speed(0));
        for (int k = first_sample + 1; k < seconds * imu_hz; ++k) {
          const auto next = imu(k);
          filter.predict((last.specific_force + next.specific_force) / 2,
                         (last.angular_rate + next.angular_rate) / 2, 1.0 / imu_hz);
          filter.update_nonholonomic(1.0 / imu_hz);
          attitudes.push_back(
              {static_cast<double>(k) / imu_hz, filter.roll() / degree, filter.pitch() / degree});
          if (k % samples_per_speed == 0) filter.update_moving(speed(k));
          last = next;
        }
      },
      any);
  return attitudes;
}

/// The largest difference of roll or pitch since `from_s`, deg. The instants of log samples are
/// left out: when a heartbeat precedes the IMU's frames, their stamps are 0.25 ms late, and the
/// filter uses the speed of that instant before them instead of after them.
double difference(const std::vector<Attitude>& direct, const summary::AttitudeTrace& wire,
                  double from_s) {
  double largest = 0;
  for (std::size_t i = 1; i < wire.t_s.size(); ++i) {
    const auto k = static_cast<int>(std::lround(wire.t_s[i] * imu_hz));
    if (k % samples_per_speed == 0 || wire.t_s[i] < from_s) continue;
    const auto& same = direct.at(static_cast<std::size_t>(k - first_sample - 1));
    EXPECT_NEAR(same.t_s, wire.t_s[i], 1e-4);  // stuff bits shift the stamps a little
    largest = std::max({largest, std::abs(same.roll_deg - wire.roll_deg[i]),
                        std::abs(same.pitch_deg - wire.pitch_deg[i])});
  }
  return largest;
}

TEST(LevelingOnTheWire, EveryFilterAgreesWithItsMeasurementsToTheWiresResolution) {
  const auto rig = two_sensors();
  testing::internal::CaptureStdout();
  bench::RunOptions options;
  options.duration_s = seconds;
  const auto summary = bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  EXPECT_TRUE(summary.all_streaming());
  using leveling::FilterKind;
  const std::array kinds{FilterKind::robust, FilterKind::augmented, FilterKind::paper};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto& wire = summary.traces.at(i);
    ASSERT_GT(wire.t_s.size(), 500U);
    // The IMU starts when its bus is up, so its second sample is the first that arrives.
    EXPECT_EQ(std::lround(wire.t_s.front() * imu_hz), first_sample);
    // Speeds are rounded to .001 knot, rates and forces to 24 bits, times to 0.03 ms. The paper's
    // filter cannot observe roll before the first turn and magnifies these roundings until then.
    const double from_s = kinds[i] == FilterKind::paper ? 20 : 0;
    EXPECT_LT(difference(straight_into(kinds[i], rig), wire, from_s), 0.001) << i;
  }
}

}  // namespace
}  // namespace leveling_wire_test
