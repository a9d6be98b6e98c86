#include "hil/motion/vehicle/mission_helm.hpp"

namespace drydock::motion {

MissionHelm::MissionHelm(const rig_config::MissionConfig& mission)
    : plan_(mission), autopilot_(mission.vehicle.value()) {}

Command MissionHelm::command(std::int64_t step, const VehicleState& state,
                             AutopilotMemory& memory) const {
  const double t = static_cast<double>(step * voyage_step_ns) * 1e-9;
  plan_.pass(state, memory.guidance);
  return autopilot_.steer(plan_.at(t, state, memory.guidance, voyage_step_s), state, memory,
                          voyage_step_s);
}

}  // namespace drydock::motion
