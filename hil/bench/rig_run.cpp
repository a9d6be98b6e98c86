#include "hil/bench/rig_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "drivers/host/rig_bus.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/control/bus_faults.hpp"
#include "hil/pilot/pilot.hpp"
#include "hil/summary/findings.hpp"
#include "hil/summary/program_verdict.hpp"
#include "hil/summary/truth_of_rig.hpp"

namespace drydock::bench {

using measurement::Stamp;

/// A sensor's measurement comes at most so long after its time.
constexpr double longest_delay_s = 1;

RigRun::RigRun(const rig_config::Rig& rig, const RunOptions& options,
               const motion::Trajectory& motion, const Setting& setting)
    : rig_(rig),
      options_(options),
      start_(setting.start),
      truth_(summary::truth_for_estimators(rig) ? &motion : nullptr),
      diagnostician_(rig, followers_),
      scribe_(rig, truth_, setting.start, setting.expected_s, options.curve_points),
      expects_(rig, truth_, setting.start, [this](Stamp now) {
        return summary::ExpectWatch::Counts{devices(now), estimators()};
      }) {
  if (setting.first != nullptr) followers_.add(*setting.first);
  followers_.add(diagnostician_);
  followers_.add(findings_);
  followers_.add(late_wakes_);
  followers_.add(scribe_);
  followers_.add(expects_);
  const bool truth_is_heard = setting.others_hear_truth || !options.record.path.empty() ||
                              std::ranges::any_of(options.followers, &Follower::hears_truth);
  if (truth_is_heard && truth_ != nullptr &&
      !(rig.estimators.empty() && !summary::no_real_device(rig)))
    followers_.add(truth_teller_.emplace(
        *truth_, followers_, setting.start,
        measurement::from_seconds(
            rig.estimators.empty() ? 0 : rig.reorder_window_s + longest_delay_s)));
  if (pilot::is_wanted(rig)) followers_.add(loop_.emplace(rig, motion, setting.start));
  if (!options.record.path.empty())
    followers_.add(recorder_.emplace(rig, options.record, setting.start, setting.when_behind));
  for (auto* follower : options.followers) followers_.add(*follower);
}

emulate::RealTimeEmulator::OnWritten RigRun::on_written() {
  if (options_.followers.empty()) return {};
  return [this](std::string_view device, const emulate::Passage& passage, Stamp written) {
    for (auto* follower : options_.followers) follower->on_written(device, passage, written);
  };
}

void RigRun::begin(const BenchView& bench) {
  bench_.emplace(bench);
  diagnostician_.watch(bench.devices);
  followers_.add(sound_devices_.emplace(rig_, bench.pipeline));
  scribe_.tick(bench.start);
  for (auto* follower : options_.followers) follower->on_start(*bench_);
}

void RigRun::tell_faults(Stamp now) {
  auto in_force = bench_->faults.in_force(now);
  if (in_force == faults_told_) return;
  followers_.on_faults(control::bus_faults(in_force), now);
  faults_told_ = std::move(in_force);
}

void RigRun::tell_health(Stamp now) {
  const host::HealthReport health([this, now] {
    host::HealthReport::Statuses statuses;
    for (const auto* device : bench_->devices)
      statuses.push_back(host::status_of(*device, device->health(now)));
    return statuses;
  });
  followers_.on_health(health, now);
}

std::vector<summary::DeviceSummary> RigRun::devices(Stamp now) const {
  std::vector<summary::DeviceSummary> all;
  for (const auto* device : bench_->devices)
    all.push_back(device::account_of(*device, device->health(now),
                                     host::provenance_of(device->options().link)));
  return all;
}

std::vector<pipeline::EstimatorStatus> RigRun::estimators() const {
  std::vector<pipeline::EstimatorStatus> all;
  for (std::size_t i = 0; i < bench_->pipeline.estimators(); ++i)
    all.push_back(bench_->pipeline.status(i));
  return all;
}

/// How the talk with estimators in other programs went.
void RigRun::write_programs(summary::Summary& summary) const {
  for (std::size_t i = 0; i < summary.estimators.size(); ++i) {
    const auto* program = bench_->pipeline.peer(i);
    if (program == nullptr) continue;
    auto& estimator = summary.estimators[i];
    estimator.program = *program;
    summary.verdicts.push_back(summary::verdict_of(estimator.name, *program));
  }
}

void RigRun::write(summary::Summary& summary) {
  summary.rig = rig_.name;
  summary.seed = rig_.seed;
  std::ranges::move(setup::pipeline_notes(rig_, bench_->pipeline),
                    std::back_inserter(summary.notes));
  if (truth_teller_) truth_teller_->finish(start_ + measurement::from_seconds(summary.duration_s));
  if (recorder_) summary.notes.push_back(recorder_->finish());
  if (recorder_ && recorder_->failed())
    summary.verdicts.push_back({"rig", "recording", summary.notes.back(), "complete"});
  if (auto note = late_wakes_.note(); !note.empty()) summary.notes.push_back(std::move(note));
  if (findings_.not_kept() > 0)
    summary.notes.push_back(fmt::format("{} more findings were not kept", findings_.not_kept()));
  summary.findings = summary::accounts_of(findings_, rig_, start_);
  scribe_.write(summary);
  if (loop_) summary.loop = loop_->account();
  write_programs(summary);
  expects_.write(summary, estimators());
}

}  // namespace drydock::bench
