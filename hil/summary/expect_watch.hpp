#pragma once

#include <functional>
#include <vector>

#include "drivers/device/device.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "hil/summary/judge.hpp"
#include "hil/summary/scribe.hpp"

namespace drydock::summary {

/// Follows a run for the [[expect]] blocks with after_s > 0. From that time on it takes counters,
/// unexpected states and the errors of estimates.
class ExpectWatch {
 public:
  using Devices = std::vector<DeviceSummary>;

  /// `truth` may be null. Rig and truth must outlive the watch.
  ExpectWatch(const rig_config::Rig& rig, const motion::Trajectory* truth,
              measurement::Stamp start);

  void note(const std::string& device, const device::Transition& change);
  void note(const pipeline::AttitudeEstimate& estimate);
  void note(const pipeline::NavigationEstimate& estimate);

  /// Call it about once a second, in lockstep exactly every second. It stores the counts at `now`
  /// when a block begins, and calls `devices` only then.
  void follow(measurement::Stamp now, const std::function<Devices()>& devices,
              const pipeline::Pipeline& pipeline);

  /// Call it at the end. Adds the pipeline's counts and the verdicts to the summary.
  void write(Summary& summary, const pipeline::Pipeline& pipeline) const;

 private:
  struct Window {
    const rig_config::ExpectConfig* expect = nullptr;
    bool begun = false;
    DeviceSummary device_before;
    pipeline::EstimatorStatus estimator_before;
    std::string other_state;
    std::uint64_t estimates = 0;
    ErrorStatistics attitude;
    NavigationRecord navigation;
  };

  bool concerns(const Window& w, std::size_t estimator, measurement::Stamp at) const;
  Findings of_device(const Window& w, const Summary& summary) const;
  Findings of_estimator(const Window& w, const Summary& summary,
                        const pipeline::Pipeline& pipeline) const;

  const rig_config::Rig& rig_;
  const motion::Trajectory* truth_;
  measurement::Stamp start_;
  std::vector<Window> windows_;  ///< one per block
};

}  // namespace drydock::summary
