#include "hil/motion/steered/steered_vehicle.hpp"

#include "estimators/frame/attitude.hpp"
#include "hil/motion/steered/fin_vehicle.hpp"
#include "hil/motion/steered/thruster_vehicle.hpp"

namespace drydock::motion {

std::unique_ptr<SteeredVehicle> make_steered_vehicle(const rig_config::MissionConfig& mission) {
  if (mission.thruster_vehicle) return std::make_unique<ThrusterVehicle>(mission);
  return std::make_unique<FinVehicle>(mission, mission.steering ? &fins_alone : &fins_of);
}

std::size_t outputs_of(const rig_config::MissionConfig& mission) {
  if (mission.thruster_vehicle) return mission.thruster_vehicle->thrusters.size();
  return mission.steering ? 4 : 3;
}

VehicleState first_state(const rig_config::MissionConfig& mission) {
  VehicleState state;
  state.latitude_rad = mission.latitude_rad;
  state.longitude_rad = mission.longitude_rad;
  state.height_m = -mission.depth_m;
  state.body_to_ned = frame::body_to_ned({0, 0, mission.heading_rad});
  return state;
}

}  // namespace drydock::motion
