#pragma once

#include <memory>

#include "drivers/host/rig_recorder.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "estimators/host/bus_estimates.hpp"
#include "hil/fault/injector.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::bench {

/// Passes estimates to the watchers of a run, in the form of the bus. The truth of the same time
/// goes before an estimate, but at most once in 40 ms.
class RunWatchers {
 public:
  /// `truth` may be null and must outlive the watchers.
  RunWatchers(const rig_config::Rig& rig, const motion::Trajectory* truth)
      : truth_(truth), truth_index_(rig.estimators.size()) {}

  host::Watchers all;

  void note(const pipeline::AttitudeEstimate& estimate);
  void note(const pipeline::NavigationEstimate& estimate);
  void note(const pipeline::InnovationReport& innovation);

 private:
  void note_truth(measurement::Stamp at);

  const motion::Trajectory* truth_;
  std::size_t truth_index_;  ///< the index after the last estimator
  measurement::Stamp last_truth_{};
  host::BusNavigation to_bus_;
};

/// Tells the watchers all faults in force at `now`, in the form for pages and recordings.
void tell_faults_to(host::Watchers& all, const std::vector<fault::FaultNow>& faults,
                    measurement::Stamp now);

}  // namespace drydock::bench
