#pragma once

#include "hil/motion/vehicle/helm.hpp"

namespace drydock::motion {

/// The autopilots, which sail the legs of a mission by the true state.
class MissionHelm final : public Helm {
 public:
  /// `mission.vehicle` must be set. Throws BadMission for legs that are not possible.
  explicit MissionHelm(const rig_config::MissionConfig& mission);

  /// Throws BadMission for legs that need more speed than the propeller gives, or that lead into
  /// the bed. It follows the track by dead reckoning in steps of a second.
  void check_plan(const rig_config::MissionConfig& mission, const ocean::Ocean& ocean) const;

  Command command(std::int64_t step, const VehicleState& state,
                  AutopilotMemory& memory) const override;
  double lap_s() const { return profile_.lap_s(); }

 private:
  MissionProfile profile_;
  Autopilot autopilot_;
};

}  // namespace drydock::motion
