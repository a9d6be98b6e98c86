#pragma once

#include <memory>

#include "drivers/host/rig_recorder.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "estimators/host/bus_estimates.hpp"
#include "hil/fault/injector.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::bench {

/// What follows a run besides its report: estimates go to them as the bus has them, each with the
/// truth of the same time before it.
class RunWatchers {
 public:
  /// `truth` may be empty and must outlive the watchers.
  RunWatchers(const rig_config::Rig& rig, const motion::Trajectory* truth)
      : truth_(truth), truth_index_(rig.estimators.size()) {}

  host::Watchers all;

  void note(const pipeline::AttitudeEstimate& estimate);
  void note(const pipeline::NavigationEstimate& estimate);
  void note(const pipeline::InnovationReport& innovation);

 private:
  void note_truth(measurement::Stamp at);

  const motion::Trajectory* truth_;
  std::size_t truth_index_;  ///< after the last estimator
  measurement::Stamp last_truth_{};
  host::BusNavigation to_bus_;
};

/// All faults in force at `now`, as pages and recordings have them.
void tell_faults_to(host::Watchers& all, const std::vector<fault::FaultNow>& faults,
                    measurement::Stamp now);

}  // namespace drydock::bench
