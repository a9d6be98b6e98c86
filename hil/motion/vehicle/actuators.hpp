#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"
#include "hil/motion/vehicle/actuator.hpp"
#include "rig_config/vehicle.hpp"

namespace drydock::motion {

/// The output of an autopilot or a schedule. rad, m/s.
struct Command {
  double delta_r = 0, delta_s = 0, delta_b = 0;  ///< rudder, stern planes, bow planes
  double speed_mps = 0;                          ///< for the propeller
};

/// Rudder, stern planes, bow planes and propeller of a vehicle, each with its own limits.
class Actuators {
 public:
  /// The surfaces start amidships. The propeller starts at the rate for `speed_mps`.
  Actuators(const rig_config::VehicleConfig& config, double speed_mps);

  void step(const Command& command, double dt);

  hydrodynamics::Control control() const;
  double propeller_radps() const { return propeller_.value(); }

 private:
  Actuator rudder_, stern_planes_, bow_planes_, propeller_;
  double advance_m_;
};

/// The same vehicle with actuators that have stops, but no lag and no rate limits.
rig_config::VehicleConfig with_ideal_actuators(rig_config::VehicleConfig config);

}  // namespace drydock::motion
