#include "hil/motion/make_trajectory.hpp"

#include "hil/motion/ballistic_trajectory.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "hil/motion/ordered/ordered_thrusters.hpp"
#include "hil/motion/ordered/ordered_trajectory.hpp"
#include "hil/motion/splined/splined_trajectory.hpp"
#include "hil/motion/steered/steered_trajectory.hpp"
#include "hil/motion/vehicle/vehicle_trajectory.hpp"
#include "rig_config/steering.hpp"

namespace drydock::motion {

std::unique_ptr<Trajectory> make_trajectory(const rig_config::MissionConfig& mission, Stamp start) {
  if (mission.ballistic) return std::make_unique<BallisticTrajectory>(mission, start);
  if (rig_config::steered_over_wires(mission) && mission.thruster_vehicle)
    return std::make_unique<OrderedThrusters>(mission, start);
  if (rig_config::steered_over_wires(mission))
    return std::make_unique<OrderedTrajectory>(mission, start);
  if (mission.track) return std::make_unique<SplinedTrajectory>(mission, start);
  if (mission.steering) return std::make_unique<SteeredTrajectory>(mission, start);
  if (mission.vehicle) return std::make_unique<VehicleTrajectory>(mission, start);
  return std::make_unique<KinematicTrajectory>(mission, start);
}

std::optional<double> flight_s(const rig_config::Rig& rig) {
  if (!rig.mission.ballistic) return {};
  const auto flight = make_trajectory(rig.mission, measurement::stamp_from_ns(rig.start_utc_ns));
  return measurement::seconds(flight->end() - flight->start());
}

}  // namespace drydock::motion
