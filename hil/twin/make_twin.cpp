#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "hil/bench/run.hpp"
#include "hil/check/check_rig.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/motion/splined/splined_trajectory.hpp"
#include "hil/report/write_file.hpp"
#include "hil/track/gatherer.hpp"
#include "hil/twin/keeper.hpp"
#include "hil/twin/lapse_text.hpp"
#include "hil/twin/mission_text.hpp"
#include "hil/twin/origin_files.hpp"
#include "hil/twin/poses_of.hpp"
#include "hil/twin/sensor_text.hpp"
#include "hil/twin/twin.hpp"

namespace drydock::twin {
namespace {

namespace fs = std::filesystem;
using measurement::Stamp;

constexpr double step_with_imu_s = 0.1, step_without_imu_s = 1;
/// A measured rate that is closer to the rig's than this is the rig's.
constexpr double same_rate = 0.02;

/// Hears what a track is made from.
class Listener final : public bench::Follower {
 public:
  Listener(const rig_config::Rig& rig, bool inertial)
      : gatherer_(rig, inertial ? imu_of(rig) : std::nullopt) {}

  void on_measurement(const measurement::Measurement& m) override { gatherer_.on_measurement(m); }
  void on_truth(const host::Estimate& truth) override { gatherer_.on_truth(truth); }
  track::Gathered take() { return gatherer_.take(); }

 private:
  static std::optional<std::uint16_t> imu_of(const rig_config::Rig& rig) {
    const auto setup = track::inertial_of(rig);
    return setup ? std::optional(setup->imu) : std::nullopt;
  }
  track::Gatherer gatherer_;
};

/// The messages of an actuator are one for each of its parts: their times do not tell its rate.
double rate_of(const DeviceStatistics& statistics, rig_config::DeviceKind kind, double nominal_hz) {
  const double rate = statistics.timing.rate_hz;
  if (kind == rig_config::DeviceKind::actuator || !(rate > 0) ||
      std::abs(rate / nominal_hz - 1) < same_rate)
    return 0;
  return std::stod(fmt::format("{:.4g}", std::clamp(rate, 0.001, 1000.0)));
}

/// The depth of a DVL's head comes in steps, which the vertical velocity of the track would follow:
/// the twin's DVL would measure more noise than the recorded one. So a twin keeps the soundings.
void leave_out_own_depth(track::Gathered& gathered) {
  if (!gathered.own_depth) return;
  std::erase_if(gathered.dive.readings, [](const smoothing::Reading& reading) {
    return reading.quantity == smoothing::Quantity::depth;
  });
  std::erase_if(gathered.unstated, [](const smoothing::UnstatedNoise& noise) {
    return noise.quantity == smoothing::Quantity::depth;
  });
  gathered.own_depth = false;
}

/// One twin, step by step: each function needs what the ones before it made.
class Making {
 public:
  explicit Making(const TwinOptions& options) : options_(options) {}

  TwinOutcome made() {
    make_track();
    measure();
    write();
    sail();
    return std::move(outcome_);
  }

 private:
  const rig_config::Rig& rig() const { return outcome_.recorded.gathered.rig; }

  void make_track() {
    auto gathered = track::gather(options_.source, &recorded_);
    leave_out_own_depth(gathered);
    outcome_.source = gathered.source;
    outcome_.folder = options_.folder;
    outcome_.recorded =
        track::smoothed(std::move(gathered), options_.source.model, options_.source.origin);
    const auto& track = outcome_.recorded;
    outcome_.every_s = options_.every_s > 0 ? options_.every_s
                       : track.inertial     ? step_with_imu_s
                                            : step_without_imu_s;
    poses_ = poses_of(track.track.smoothed, outcome_.every_s);
    outcome_.poses = poses_.size();
    start_ = track.gathered.start + measurement::from_seconds(track.track.smoothed.front().time_s);
  }

  /// The bed and the current first: the errors of logs and of pressures are against them.
  void measure() {
    double deepest_m = deepest();
    const auto& origin = poses_.front().position;
    const auto in = [&](const rig_config::OceanConfig& config) {
      return motion::SplinedTrajectory(
          poses_, ocean::Ocean(config, {origin.latitude_rad, origin.longitude_rad, 0}), start_);
    };
    rig_config::OceanConfig deep;
    deep.bed.depth_m = deepest_m + 1000;
    if (!track::has(outcome_.recorded.gathered.dive, smoothing::Quantity::depth)) {
      level_the_bed(in(deep));
      deepest_m = deepest();
    }
    outcome_.surroundings = surroundings_of(recorded_.kept(), rig(), in(deep));
    ocean_ = ocean_of(outcome_.surroundings, deepest_m);
    const auto track = in(ocean_);
    for (std::size_t i = 0; i < rig().devices.size(); ++i) {
      const auto& device = rig().devices[i];
      outcome_.devices.push_back(
          {device.name, device.kind, statistics_at(recorded_.kept(), i, device, track), {}});
    }
  }

  /// Without a depth sensor the track's height drifts, but the soundings see it.
  void level_the_bed(const motion::Trajectory& track) {
    std::vector<double> times_s;
    for (const auto& pose : poses_) times_s.push_back(pose.t_s);
    const auto beds = bed_along(recorded_.kept(), rig(), track, times_s);
    for (std::size_t i = 0; i < beds.size(); ++i)
      poses_[i].position.height_m += beds[i] - beds.front();
    keep_under_water();
    outcome_.notes.emplace_back(
        "no depth sensor: the vehicle keeps its height above a level bed; where it is "
        "highest it is at the surface");
  }

  /// Over a bed that rises, a vehicle at the surface would leave the water, and its DVL the bed.
  void keep_under_water() {
    double highest_m = 0;
    for (const auto& pose : poses_) highest_m = std::max(highest_m, pose.position.height_m);
    for (auto& pose : poses_) pose.position.height_m -= highest_m;
  }

  double deepest() const {
    double deepest_m = 0;
    for (const auto& pose : poses_) deepest_m = std::max(deepest_m, -pose.position.height_m);
    return deepest_m;
  }

  static DeviceStatistics statistics_at(const ByDevice& kept, std::size_t i,
                                        const rig_config::DeviceConfig& device,
                                        const motion::Trajectory& track) {
    if (i >= kept.size()) return {};
    auto statistics = statistics_of(errors_of(kept[i], device, track), device.kind);
    if (device.kind == rig_config::DeviceKind::actuator)
      statistics.timing = timing_of(times_of(kept[i]));
    return statistics;
  }

  static std::vector<Error> times_of(const std::vector<measurement::Measurement>& measured) {
    std::vector<Error> times;
    times.reserve(measured.size());
    for (const auto& m : measured)
      times.push_back({.valid_at = measurement::origin_of(m).valid_at});
    return times;
  }

  void write() {
    const fs::path folder = options_.folder;
    const auto kind = rig().devices.front().kind;
    const auto origin = copy_rig_of(options_.source, kind, options_.folder);
    TwinRig twin{start_, {}, {}, origin.folder, origin.files};
    for (const auto& estimator : rig().estimators) twin.estimators.push_back(estimator.name);
    std::string lapses;
    for (std::size_t i = 0; i < rig().devices.size(); ++i) {
      const auto& device = rig().devices[i];
      const auto& statistics = outcome_.devices[i].recorded;
      twin.devices.push_back({device.name, {}, rate_of(statistics, device.kind, device.rate_hz)});
      if (statistics.timing.samples == 0)
        outcome_.notes.push_back(device.name + ": nothing was recorded of it");
      if (statistics.timing.samples == 0 || device.kind == rig_config::DeviceKind::actuator)
        continue;
      lapses += lapse_text(statistics, device.name, device.kind, start_);
      const bool coarse = device.kind == rig_config::DeviceKind::imu && !outcome_.recorded.inertial;
      twin.devices.back().errors = "sensors/" + device.name + ".toml";
      report::write_file(folder / twin.devices.back().errors,
                         sensor_text(statistics, device.kind, coarse));
      if (coarse)
        outcome_.notes.push_back(device.name +
                                 ": the track has no IMU in it, so of this one only the white "
                                 "noise is known");
    }
    report::write_file(folder / "track.csv", poses_text(poses_));
    report::write_file(folder / "mission.toml",
                       mission_text(poses_, ocean_, outcome_.source) + lapses);
    report::write_file(folder / "rig.toml", twin_rig_text(origin.text, twin));
  }

  void sail() {
    const auto file = (fs::path(options_.folder) / "rig.toml").string();
    const auto rig = check::load_sound_rig(file, check::Use::lockstep);
    if (!rig) throw std::runtime_error(to_string(rig.error().front()));
    const auto truth =
        motion::make_trajectory(rig->mission, measurement::stamp_from_ns(rig->start_utc_ns));
    Keeper sailed;
    Listener listener(*rig, outcome_.recorded.inertial);
    bench::RunOptions run;
    run.duration_s = measurement::seconds(truth->end() - truth->start());
    run.lockstep = run.quiet = true;
    run.followers = {&sailed, &listener};
    bench::run_lockstep(*rig, run);
    for (std::size_t i = 0; i < rig->devices.size(); ++i)
      outcome_.devices[i].twin = statistics_at(sailed.kept(), i, rig->devices[i], *truth);
    track_again(listener.take());
  }

  void track_again(track::Gathered gathered) {
    leave_out_own_depth(gathered);
    try {
      outcome_.sailed =
          track::smoothed(std::move(gathered),
                          outcome_.recorded.inertial ? track::Model::inertial : track::Model::level,
                          poses_.front().position);
    } catch (const std::runtime_error& error) {
      outcome_.notes.push_back(fmt::format("no track of the twin: {}", error.what()));
    }
  }

  const TwinOptions& options_;
  Keeper recorded_;
  TwinOutcome outcome_;
  motion::Poses poses_;
  rig_config::OceanConfig ocean_;
  Stamp start_{};
};

}  // namespace

TwinOutcome make_twin(const TwinOptions& options) { return Making(options).made(); }

}  // namespace drydock::twin
