#pragma once

#include "drivers/host/follower.hpp"
#include "hil/motion/truth.hpp"
#include "hil/motion/vehicle/mission_plan.hpp"
#include "hil/pilot/loop_account.hpp"
#include "rig_config/rig.hpp"

namespace drydock::bench {

/// Follows a vehicle that is steered over the wires along its plan, ten times a second, beside the
/// same plan sailed by the autopilots inside the simulation.
class LoopRecord final : public host::Follower {
 public:
  /// All arguments must outlive the record.
  LoopRecord(const rig_config::Rig& rig, const motion::Trajectory& truth, Stamp start);

  void on_measurement(const measurement::Measurement& m) override;
  pilot::LoopAccount account() const;

 private:
  void sample(Stamp at);
  void follow(const motion::VehicleState& state, double t);

  const rig_config::MissionConfig& mission_;
  const motion::Trajectory& truth_;
  std::unique_ptr<motion::Trajectory> in_process_;
  motion::MissionPlan plan_;
  motion::GuidanceMemory guidance_;
  Stamp start_, next_;
  pilot::LoopAccount account_;
};

}  // namespace drydock::bench
