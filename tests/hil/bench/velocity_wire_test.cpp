// The velocity filters on one mission twice: measurements go directly into the study's navigators,
// and the same measurements go through emulated devices, wire bytes, drivers and the pipeline in
// lockstep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "estimators/hydrodynamics/model.hpp"
#include "estimators/setup/options_of.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/bench/run.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/motion/remembered_trajectory.hpp"
#include "hil/sensor/ideal.hpp"
#include "hil/sensor/imu_errors.hpp"
#include "hil/sensor/imu_sampler.hpp"
#include "hil/study/velocity/velocity_methods.hpp"
#include "rig_config/load.hpp"

namespace drydock::bench::velocity_wire_test {
namespace {

using measurement::Stamp;
using rig_config::LegKind;

constexpr double seconds_sailed = 600;
constexpr int step_ms = 100;

/// The paper's rig on a short mission: ten minutes with a dive, a spiral and a zigzag; the bed is
/// out of range for a part. Biases are as drawn and there is no noise, so the two ways differ only
/// by the wire.
rig_config::Rig brief_mission() {
  auto rig =
      rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/velocity-paper.toml").value();
  auto& legs = rig.mission.legs;
  const auto leg_of = [&](LegKind kind, double duration_s) {
    auto leg = *std::ranges::find(legs, kind, &rig_config::LegConfig::kind);
    leg.duration_s = duration_s;
    return leg;
  };
  auto dive = leg_of(LegKind::dive, 90);
  dive.depth_change_m = 40;
  auto zigzag = leg_of(LegKind::zigzag, 240);
  zigzag.period_s = 240;
  zigzag.amplitude_rad = 0.3;
  auto spiral = leg_of(LegKind::spiral, 120);
  spiral.ramp_s = 20;
  legs = {leg_of(LegKind::straight, 90), dive, spiral, zigzag, leg_of(LegKind::straight, 60)};
  for (auto& device : rig.devices) {
    for (auto* errors : {&device.emulate.primary, &device.emulate.secondary})
      errors->noise = errors->noise_density = {};
    if (device.kind == rig_config::DeviceKind::dvl) device.emulate.head.longest_range_m = 365;
  }
  return rig;
}

summary::Summary through_wires(const rig_config::Rig& rig) {
  testing::internal::CaptureStdout();
  RunOptions options;
  options.duration_s = seconds_sailed;
  auto summary = run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return summary;
}

const rig_config::DeviceConfig& named(const rig_config::Rig& rig, const char* name) {
  return *std::ranges::find(rig.devices, name, &rig_config::DeviceConfig::name);
}

/// The tenths of a second at which the DVL had the bed. The test does not model the DVL's head.
std::set<int> tenths_with_bed(const summary::Summary& wires) {
  const auto track = std::ranges::find_if(wires.measurements,
                                          [](const auto& m) { return m.title.starts_with("dvl"); });
  std::set<int> tenths;
  for (const double t : track->t_s[0]) tenths.insert(static_cast<int>(std::lround(10 * t)));
  return tenths;
}

struct Error {
  double north_m, east_m, north_mps, east_mps;
};

/// The errors of a study's navigator after each tenth of a second, without a wire.
std::vector<Error> straight_into(study::Method method, const rig_config::Rig& rig,
                                 const std::set<int>& bed) {
  const Stamp start = measurement::stamp_from_ns(rig.start_utc_ns);
  const motion::RememberedTrajectory truth(motion::make_trajectory(rig.mission, start));
  const auto& unit = named(rig, "imu");
  sensor::ImuErrors imu_errors(unit.emulate, unit.rate_hz, rig.seed, unit.name);
  sensor::ImuSampler imu(truth, {}, unit.rate_hz, true);
  imu_errors.apply(imu.at(start));  // the emulated unit takes this sample at the start
  const auto& estimator = rig.estimators.at(0);
  const auto options =
      setup::options_of(std::get<rig_config::VelocityConfig>(estimator.kind), {rig, estimator});
  const auto navigator =
      study::make_navigator(method, options.start, hydrodynamics::Model(options.vehicle));

  std::vector<Error> errors;
  study::MeasuredStep measured;
  for (int tenth = 1; tenth <= 10 * seconds_sailed; ++tenth) {
    measured.mean_height_m = 0;
    for (std::size_t i = 0; i < study::MeasuredStep::samples; ++i) {
      const Stamp at = start + std::chrono::milliseconds{step_ms} * (tenth - 1) +
                       std::chrono::milliseconds{10} * (i + 1);
      const auto sample = imu_errors.apply(imu.at(at));
      measured.angle[i] = 0.01 * sample.angular_rate;
      measured.velocity[i] = 0.01 * sample.specific_force;
      measured.height_m[i] = truth.at(at).height_m;
      measured.mean_height_m += measured.height_m[i] / study::MeasuredStep::samples;
      const auto middle = truth.at(at - std::chrono::milliseconds{5});
      measured.control[i] = {.delta_r = middle.rudder_rad,
                             .delta_s = middle.stern_plane_rad,
                             .delta_b = middle.bow_plane_rad,
                             .u_c = options.advance_m * middle.propeller_radps};
    }
    const auto now = truth.at(start + std::chrono::milliseconds{step_ms} * tenth);
    measured.log_mps.reset();
    measured.ground.reset();
    if (tenth % 5 == 0) measured.log_mps = (now.velocity_ned - now.current_ned).norm();
    if (bed.contains(tenth)) measured.ground = now.velocity_body;
    navigator->step(measured);
    const auto off = frame::ned_offset({now.latitude_rad, now.longitude_rad, now.height_m},
                                       navigator->state().position);
    const Eigen::Vector3d v = navigator->state().velocity_ned - now.velocity_ned;
    errors.push_back({off.x(), off.y(), v.x(), v.y()});
  }
  return errors;
}

struct Apart {
  double metres = 0, metres_per_second = 0;
};

Apart largest_difference(const std::vector<Error>& direct, const summary::NavigationTrace& wire) {
  Apart apart;
  for (std::size_t i = 0; i < wire.t_s.size(); ++i) {
    const auto tenth = std::lround(10 * wire.t_s[i]);
    EXPECT_NEAR(wire.t_s[i], 0.1 * static_cast<double>(tenth), 2e-3);
    if (tenth < 50 || tenth > static_cast<long>(direct.size())) continue;
    const Error& same = direct[static_cast<std::size_t>(tenth - 1)];
    apart.metres = std::max(apart.metres, std::hypot(wire.north_error_m[i] - same.north_m,
                                                     wire.east_error_m[i] - same.east_m));
    apart.metres_per_second = std::max(apart.metres_per_second,
                                       std::hypot(wire.velocity_error_mps[0][i] - same.north_mps,
                                                  wire.velocity_error_mps[1][i] - same.east_mps));
  }
  return apart;
}

TEST(VelocityOnTheWire, BothFiltersAgreeWithTheStudysToTheWiresResolution) {
  const auto rig = brief_mission();
  const auto wires = through_wires(rig);
  EXPECT_EQ(wires.notes, std::vector<std::string>{});
  const auto bed = tenths_with_bed(wires);
  EXPECT_GT(bed.size(), 100u);
  EXPECT_LT(bed.size(), 500u);  // the bed goes out of range on the way
  constexpr std::array methods{study::Method::ours, study::Method::paper};
  // Speeds are rounded to .001 knot (log) and 1 mm/s (DVL), rates and forces to 24 bits. The study
  // has the actuators every 10 ms, in the middle of the sample; the wire has them every 100 ms and
  // holds them. The paper's simulator depends on them for everything, our filter only for sway.
  constexpr std::array limits{Apart{0.05, 0.0005}, Apart{0.15, 0.004}};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const auto direct = straight_into(methods[i], rig, bed);
    ASSERT_GT(wires.navigation.at(i).t_s.size(), 1000u);
    const auto apart = largest_difference(direct, wires.navigation[i]);
    RecordProperty(wires.estimators[i].name + "_m", std::to_string(apart.metres));
    RecordProperty(wires.estimators[i].name + "_mps", std::to_string(apart.metres_per_second));
    EXPECT_LT(apart.metres, limits[i].metres) << wires.estimators[i].name;
    EXPECT_LT(apart.metres_per_second, limits[i].metres_per_second) << wires.estimators[i].name;
  }
}

}  // namespace
}  // namespace drydock::bench::velocity_wire_test
