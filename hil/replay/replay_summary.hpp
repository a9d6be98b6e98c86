#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "hil/replay/recorded_trajectory.hpp"
#include "hil/replay/replay_bench.hpp"
#include "hil/summary/expect_watch.hpp"
#include "hil/summary/scribe.hpp"

namespace drydock::replay {

/// What a replay was worth, as the summary of a run says it: errors against the recorded truth,
/// verdicts on the rig's [[expect]].
class ReplaySummary {
 public:
  /// Adds itself to the bench's followers. All must outlive it. Every device of the rig must be
  /// played. `truth`: null if there is none.
  ReplaySummary(const rig_config::Rig& rig, ReplayBench& bench, const std::string& recording,
                std::unique_ptr<RecordedTrajectory> truth);

  /// Call it before the devices close.
  void note_end() { at_end_ = devices(); }
  /// Call it after the replay. Findings are the caller's.
  summary::Summary made() const;

 private:
  std::vector<summary::DeviceSummary> devices() const;
  std::vector<pipeline::EstimatorStatus> estimators() const;
  void write_programs(summary::Summary& summary) const;

  const rig_config::Rig& rig_;
  ReplayBench& bench_;
  std::string recording_;
  std::unique_ptr<RecordedTrajectory> truth_;  ///< null: none was recorded
  summary::Scribe scribe_;
  summary::ExpectWatch expects_;
  std::vector<summary::DeviceSummary> at_end_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// What is missing in a recording was judged by nobody. Empty: nothing is.
std::optional<summary::Verdict> verdict_on(const record::Recording& recording);

}  // namespace drydock::replay
