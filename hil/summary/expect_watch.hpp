#pragma once

#include <functional>
#include <vector>

#include "drivers/host/follower.hpp"
#include "estimators/pipeline/estimator.hpp"
#include "hil/summary/judge.hpp"
#include "hil/summary/scribe.hpp"

namespace drydock::summary {

/// Follows a run for the [[expect]] blocks with after_s > 0. From that time on it takes counters,
/// unexpected states and the errors of estimates.
class ExpectWatch final : public host::Follower {
 public:
  /// The counts of devices and estimators, in the order of the rig.
  struct Counts {
    std::vector<DeviceSummary> devices;
    std::vector<pipeline::EstimatorStatus> estimators;
  };

  /// `truth` may be null. Rig and truth must outlive the watch. `counts` is called when a block
  /// begins.
  ExpectWatch(const rig_config::Rig& rig, const motion::Trajectory* truth, measurement::Stamp start,
              std::function<Counts(measurement::Stamp now)> counts);

  void on_state(const device::Device& device, const device::Transition& change) override;
  void on_estimate(const host::Estimate& estimate) override;
  void on_clock_step(std::chrono::nanoseconds step) override { stepped_ += step; }
  void tick(measurement::Stamp now) override;

  /// Call it at the end. Adds the estimators' counts and the verdicts to the summary.
  void write(Summary& summary, const std::vector<pipeline::EstimatorStatus>& at_end) const;

 private:
  struct Window {
    const rig_config::ExpectConfig* expect = nullptr;
    bool begun = false;
    double begun_s = 0;
    DeviceSummary device_before;
    pipeline::EstimatorStatus estimator_before;
    std::string other_state;
    std::uint64_t estimates = 0;
    ErrorStatistics attitude;
    RateCount rate;
    NavigationRecord navigation;
  };

  /// A message's time in the time of the start, which no step of the host's clock changes.
  measurement::Stamp steady(measurement::Stamp at) const { return at - stepped_; }
  bool concerns(const Window& w, std::size_t estimator, measurement::Stamp at) const;
  std::string absent_from_rig(const rig_config::ExpectConfig& expect) const;
  Outcome of_device(const Window& w, const Summary& summary) const;
  Outcome of_estimator(const Window& w, const Summary& summary,
                       const std::vector<pipeline::EstimatorStatus>& at_end) const;

  const rig_config::Rig& rig_;
  const motion::Trajectory* truth_;
  measurement::Stamp start_;
  std::chrono::nanoseconds stepped_{0};
  std::function<Counts(measurement::Stamp)> counts_;
  std::vector<Window> windows_;  ///< one per block
};

}  // namespace drydock::summary
