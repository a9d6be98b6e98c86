#include "hil/motion/ordered/ordered_trajectory.hpp"

#include "hil/motion/vehicle/vehicle_trajectory.hpp"
#include "rig_config/steering.hpp"

namespace drydock::motion {

namespace {

double planned_s(const rig_config::MissionConfig& mission, const ocean::Ocean& ocean) {
  const MissionPlan plan(mission);
  if (rig_config::has_plan(mission)) plan.check(mission, ocean);
  return plan.planned_s();
}

}  // namespace

OrderedTrajectory::OrderedTrajectory(const rig_config::MissionConfig& mission, Stamp start)
    : orders_(mission.vehicle.value(), mission.speed_mps, start),
      voyage_(mission, orders_, Edges::closed),
      start_(start),
      planned_s_(planned_s(mission, ocean())) {}

Truth OrderedTrajectory::at(Stamp time) const { return truth_at(voyage_, start_, time); }

Stamp OrderedTrajectory::end() const { return start_ + measurement::from_seconds(planned_s_); }

}  // namespace drydock::motion
