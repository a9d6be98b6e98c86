#pragma once

#include "estimators/hydrodynamics/model.hpp"
#include "hil/motion/vehicle/actuators.hpp"

namespace drydock::motion {

/// A vehicle under command in virtual time: its actuators and its equations of motion.
class SimulatedVehicle {
 public:
  /// The propeller starts at the rate for the state's u. Throws std::invalid_argument, see
  /// hydrodynamics::Model.
  SimulatedVehicle(const rig_config::VehicleConfig& config, const hydrodynamics::State& state);

  /// Advances by dt seconds (0.02 or less, because the fastest lag is 0.1 s) with a held command.
  /// The equations use the actuators in the middle of the step.
  void step(const Command& command, double dt,
            const hydrodynamics::Surroundings& surroundings = {});

  const hydrodynamics::State& state() const { return state_; }
  const hydrodynamics::Model& model() const { return model_; }
  const Actuators& actuators() const { return actuators_; }

 private:
  hydrodynamics::Model model_;
  Actuators actuators_;
  hydrodynamics::State state_;
};

}  // namespace drydock::motion
