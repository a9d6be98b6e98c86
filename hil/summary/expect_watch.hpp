#pragma once

#include <functional>
#include <vector>

#include "drivers/device/device.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "hil/summary/judge.hpp"
#include "hil/summary/scribe.hpp"

namespace drydock::summary {

/// Follows a run for those [[expect]] of its rig that begin some time after the start: counters
/// from there on, states that were not expected, errors of the later estimates.
class ExpectWatch {
 public:
  using Devices = std::vector<DeviceSummary>;

  /// `truth` may be empty. Rig and truth must outlive the watch.
  ExpectWatch(const rig_config::Rig& rig, const motion::Trajectory* truth,
              measurement::Stamp start);

  void note(const std::string& device, const device::Transition& change);
  void note(const pipeline::AttitudeEstimate& estimate);
  void note(const pipeline::NavigationEstimate& estimate);

  /// To be called about once a second, in lockstep at each: what had been counted by `now`.
  /// `devices` is asked only when a block begins.
  void follow(measurement::Stamp now, const std::function<Devices()>& devices,
              const pipeline::Pipeline& pipeline);

  /// At the end: gives the summary what the pipeline counted, and its verdicts.
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
  std::vector<Window> windows_;  ///< one a block
};

}  // namespace drydock::summary
