#pragma once

#include "hil/motion/vehicle/helm.hpp"
#include "hil/motion/vehicle/mission_plan.hpp"

namespace drydock::motion {

/// The autopilots, which sail the legs or the waypoints of a mission by the true state.
class MissionHelm final : public Helm {
 public:
  /// `mission.vehicle` must be set. Throws as MissionPlan.
  explicit MissionHelm(const rig_config::MissionConfig& mission);

  Command command(std::int64_t step, const VehicleState& state,
                  AutopilotMemory& memory) const override;
  const MissionPlan& plan() const { return plan_; }

 private:
  MissionPlan plan_;
  Autopilot autopilot_;
};

}  // namespace drydock::motion
