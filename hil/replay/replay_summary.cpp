#include "hil/replay/replay_summary.hpp"

#include "drivers/device/health_account.hpp"
#include "drivers/host/rig_bus.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/replay/other_programs.hpp"

namespace drydock::replay {

namespace {

/// For the spacing of the report's curves.
double length_s(const motion::Trajectory* truth) {
  constexpr double usual_s = 600;
  return truth != nullptr ? measurement::seconds(truth->end() - truth->start()) : usual_s;
}

}  // namespace

ReplaySummary::ReplaySummary(const rig_config::Rig& rig, ReplayBench& bench,
                             const std::string& recording,
                             std::unique_ptr<RecordedTrajectory> truth)
    : rig_(rig),
      bench_(bench),
      recording_(recording),
      truth_(std::move(truth)),
      scribe_(rig, truth_.get(), bench.start(), length_s(truth_.get())),
      expects_(rig, truth_.get(), bench.start(), [this](measurement::Stamp) {
        return summary::ExpectWatch::Counts{devices(), estimators()};
      }) {
  bench.followers().add(scribe_);
  bench.followers().add(expects_);
  scribe_.tick(bench.start());
}

std::vector<summary::DeviceSummary> ReplaySummary::devices() const {
  const auto now = bench_.player().now();
  std::vector<summary::DeviceSummary> all;
  for (const auto* device : bench_.devices())
    all.push_back(
        device::account_of(*device, device->health(now), measurement::Provenance::replayed));
  return all;
}

std::vector<pipeline::EstimatorStatus> ReplaySummary::estimators() const {
  std::vector<pipeline::EstimatorStatus> all;
  for (std::size_t i = 0; i < bench_.pipeline().estimators(); ++i)
    all.push_back(bench_.pipeline().status(i));
  return all;
}

void ReplaySummary::write_programs(summary::Summary& summary) const {
  for (std::size_t i = 0; i < summary.estimators.size(); ++i)
    if (const auto* program = bench_.pipeline().peer(i)) summary.estimators[i].program = *program;
  summary.verdicts = verdicts_on_programs(rig_, bench_.pipeline());
}

summary::Summary ReplaySummary::made() const {
  summary::Summary summary;
  summary.rig = rig_.name;
  summary.mode = "replay";
  summary.seed = rig_.seed;
  summary.duration_s = measurement::seconds(bench_.played());
  summary.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  summary.interrupted = bench_.interrupted();
  summary.notes = setup::pipeline_notes(rig_, bench_.pipeline());
  summary.notes.push_back("replay of " + recording_ +
                          (truth_ ? "" : ", which has no truth: no errors are known"));
  summary.devices = at_end_;
  scribe_.write(summary);
  write_programs(summary);
  expects_.write(summary, estimators());
  return summary;
}

std::optional<summary::Verdict> verdict_on(const record::Recording& recording) {
  if (recording.damage().empty()) return {};
  return summary::Verdict{.subject = "rig",
                          .what = "recording",
                          .measured = "damaged: " + recording.damage(),
                          .expected = "whole"};
}

}  // namespace drydock::replay
