#pragma once

#include <cstdint>

#include "hil/motion/vehicle/helm.hpp"
#include "hil/motion/vehicle/steps_on_demand.hpp"

namespace drydock::motion {

/// A vehicle at one step, with the command until the next step.
struct VoyageStep {
  VehicleState state;
  VehicleRate rate;
  Actuators actuators;
  AutopilotMemory memory;
  Command command;
};

/// The steps of a vehicle under a helm.
class Voyage {
 public:
  /// Begins where the mission does, at its speed. The helm must outlive the voyage. Throws
  /// std::invalid_argument for a vehicle that is not possible.
  Voyage(const rig_config::MissionConfig& mission, const Helm& helm, Edges edges);

  VoyageStep at(std::int64_t step) const;  ///< from 0 on; any order, any thread

  const VehicleMotion& motion() const { return motion_; }

 private:
  VoyageStep first(const rig_config::MissionConfig& mission) const;
  VoyageStep after(const VoyageStep& step, std::int64_t index) const;
  void complete(VoyageStep& step, std::int64_t index) const;
  void keep_in_reach(const VehicleState& before, VehicleState& now) const;

  VehicleMotion motion_;
  const Helm& helm_;
  Edges edges_;
  mutable StepsOnDemand<VoyageStep> steps_;
};

}  // namespace drydock::motion
