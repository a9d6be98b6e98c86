#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "drivers/host/rig_bus.hpp"
#include "drivers/terminal/interrupt_flag.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/bench/lockstep_bench.hpp"
#include "hil/bench/run.hpp"
#include "hil/bench/run_watchers.hpp"
#include "hil/control/live_faults.hpp"
#include "hil/fault/schedule/chronicle.hpp"
#include "hil/motion/remembered_trajectory.hpp"
#include "hil/summary/expect_watch.hpp"
#include "hil/summary/scribe.hpp"
#include "hil/summary/truth_of_rig.hpp"

namespace drydock::bench {
namespace {

using measurement::Stamp;

/// A run in lockstep with all its listeners: the report's scribe, expectations, recorder.
class LockstepRun final : private device::Listener, private pipeline::EstimateListener {
 public:
  LockstepRun(const rig_config::Rig& rig, const RunOptions& options)
      : rig_(rig),
        on_measurement_hook_(options.on_measurement),
        each_second_(options.each_second),
        quiet_(options.quiet),
        start_(measurement::stamp_from_ns(rig.start_utc_ns)),
        trajectory_(motion::make_trajectory(rig.mission, start_)),
        duration_s_(options.duration_s > 0 ? options.duration_s
                                           : measurement::seconds(trajectory_.end() - start_)),
        scribe_(rig, summary::truth_for_estimators(rig) ? &trajectory_ : nullptr, start_,
                duration_s_, options.curve_points),
        expects_(rig, summary::truth_for_estimators(rig) ? &trajectory_ : nullptr, start_),
        watchers_(rig, summary::truth_for_estimators(rig) ? &trajectory_ : nullptr),
        bench_(rig, trajectory_, {*this, *this, watchers_.all, options.on_written}),
        chronicle_(bench_.faults(), start_) {
    if (!quiet_ && ::isatty(STDOUT_FILENO) != 1)
      chronicle_.set_on_change([this](const fault::Episode& episode) {
        fmt::print("{}\n", control::line_of(episode, start_));
      });
    for (std::size_t i = 0; i < bench_.devices(); ++i) devices_.push_back(&bench_.device(i));
    if (options.record.path.empty()) return;
    recorder_.emplace(rig, options.record, start_, record::WhenBehind::wait);
    watchers_.all.add(*recorder_);
  }

  summary::Summary run() {
    const terminal::InterruptFlag interrupted;
    const auto wall_start = std::chrono::steady_clock::now();
    const Stamp end = start_ + measurement::from_seconds(duration_s_);
    scribe_.follow(start_);
    while (bench_.now() < end && !interrupted.set()) {
      bench_.run_until(std::min(end, bench_.now() + std::chrono::seconds{1}));
      scribe_.follow(bench_.now());
      chronicle_.follow(bench_.now());
      expects_.follow(
          bench_.now(), [this] { return devices(); }, bench_.pipeline());
      tell_watchers();
      if (each_second_) each_second_({bench_.now(), devices_, bench_.faults()});
      show_progress();
    }
    bench_.flush();
    summary::Summary s;
    s.rig = rig_.name;
    s.mode = "lockstep";
    s.seed = rig_.seed;
    s.duration_s = measurement::seconds(bench_.now() - start_);
    s.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
    s.interrupted = interrupted.set();
    s.devices = devices();
    s.notes = setup::pipeline_notes(rig_, bench_.pipeline());
    if (recorder_) s.notes.push_back(recorder_->finish());
    scribe_.write(s);
    expects_.write(s, bench_.pipeline());
    control::write(chronicle_, start_, s);
    return s;
  }

 private:
  std::vector<summary::DeviceSummary> devices() const {
    std::vector<summary::DeviceSummary> all;
    for (std::size_t i = 0; i < bench_.devices(); ++i) {
      const auto& device = bench_.device(i);
      all.push_back(device::account_of(device, device.health(bench_.now()),
                                       host::provenance_of(device.options().link)));
    }
    return all;
  }

  void on_measurement(const measurement::Measurement& m) override {
    scribe_.note(m);
    watchers_.all.note(m);
    if (on_measurement_hook_) on_measurement_hook_(m);
  }

  void on_state(const device::Device& device, const device::Transition& change) override {
    expects_.note(device.name(), change);
    if (quiet_ || ::isatty(STDOUT_FILENO) == 1) return;
    fmt::print("{:.3f} s {}: {} -> {}: {}\n", measurement::seconds(change.at - start_),
               device.name(), to_string(change.from), to_string(change.to), change.why.view());
  }

  void on_attitude(const pipeline::AttitudeEstimate& estimate) override {
    scribe_.note(estimate);
    expects_.note(estimate);
    watchers_.note(estimate);
  }
  void on_navigation(const pipeline::NavigationEstimate& estimate) override {
    scribe_.note(estimate);
    expects_.note(estimate);
    watchers_.note(estimate);
  }

  void on_innovation(const pipeline::InnovationReport& report) override { watchers_.note(report); }

  void tell_watchers() {
    if (watchers_.all.empty()) return;
    tell_faults();
    std::vector<bus::DeviceStatus> health;
    for (std::size_t i = 0; i < bench_.devices(); ++i)
      health.push_back(host::status_of(bench_.device(i), bench_.device(i).health(bench_.now())));
    watchers_.all.note(health, bench_.now());
    watchers_.all.tick(bench_.now());
  }

  void tell_faults() {
    auto now = bench_.faults().in_force(bench_.now());
    if (now == faults_told_) return;
    tell_faults_to(watchers_.all, now, bench_.now());
    faults_told_ = std::move(now);
  }

  void show_progress() const {
    if (::isatty(STDOUT_FILENO) != 1) return;
    const double done = measurement::seconds(bench_.now() - start_);
    fmt::print("\r{:.0f} s of {:.0f} s ({:.0f} %)", done, duration_s_, 100 * done / duration_s_);
    std::fflush(stdout);
  }

  const rig_config::Rig& rig_;
  std::function<void(const measurement::Measurement&)> on_measurement_hook_;
  std::function<void(const RunView&)> each_second_;
  bool quiet_;
  Stamp start_;
  motion::RememberedTrajectory trajectory_;
  double duration_s_;
  summary::Scribe scribe_;
  summary::ExpectWatch expects_;
  RunWatchers watchers_;
  std::optional<host::RigRecorder> recorder_;
  LockstepBench bench_;
  fault::Chronicle chronicle_;
  std::vector<const device::Device*> devices_;
  std::vector<fault::FaultNow> faults_told_;
};

}  // namespace

summary::Summary run_lockstep(const rig_config::Rig& rig, const RunOptions& options) {
  return LockstepRun(rig, options).run();
}

}  // namespace drydock::bench
