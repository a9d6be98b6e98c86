#pragma once

#include "estimators/frame/geodetic.hpp"
#include "hil/motion/vehicle/vehicle_motion.hpp"
#include "hil/motion/waypoint_guidance.hpp"

namespace drydock::motion {

/// What a mission wants of those who sail it: its legs by the time, its waypoints by the place.
class MissionPlan {
 public:
  /// Throws BadMission for legs and waypoints that are not possible.
  explicit MissionPlan(const rig_config::MissionConfig& mission);

  /// For the next dt seconds. `t` counts from the start; of `state` the place counts.
  Prescribed at(double t, const VehicleState& state, GuidanceMemory& memory, double dt) const;

  /// To be asked before at(): the waypoint that the vehicle leaves behind now.
  std::optional<Passed> pass(const VehicleState& state, GuidanceMemory& memory) const;

  double planned_s() const;  ///< legs: one lap; waypoints: in still water

  /// Throws BadMission for a plan that needs more speed than the propeller gives, or that leads
  /// into the bed. `mission` is that of the plan.
  void check(const rig_config::MissionConfig& mission, const ocean::Ocean& ocean) const;

  Eigen::Vector2d north_east_m(const VehicleState& state) const;  ///< from where it begins
  const std::optional<WaypointGuidance>& guidance() const { return guidance_; }

 private:
  void check_legs(const rig_config::MissionConfig& mission, const ocean::Ocean& ocean) const;
  void check_lines(double fastest_mps, const ocean::Ocean& ocean) const;

  frame::Position begin_;
  MissionProfile profile_;
  std::optional<WaypointGuidance> guidance_;  ///< empty: legs
};

}  // namespace drydock::motion
