#include "hil/motion/vehicle/simulated_vehicle.hpp"

#include "estimators/vehicle/vehicle.hpp"

namespace drydock::motion {

SimulatedVehicle::SimulatedVehicle(const rig_config::VehicleConfig& config,
                                   const hydrodynamics::State& state)
    : model_(vehicle::dimensional(config)), actuators_(config, state[0]), state_(state) {}

void SimulatedVehicle::step(const Command& command, double dt,
                            const hydrodynamics::Surroundings& surroundings) {
  actuators_.step(command, dt / 2);
  state_ = model_.step(state_, actuators_.control(), dt, surroundings);
  actuators_.step(command, dt / 2);
}

}  // namespace drydock::motion
