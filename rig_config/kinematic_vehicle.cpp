#include "rig_config/kinematic_vehicle.hpp"

#include "drivers/measurement/units.hpp"

namespace drydock::rig_config {

VehicleConfig kinematic_vehicle() {
  const SurfaceConfig surface{
      .limit_rad = 20 * units::degree, .rate_limit_radps = 2.5 * units::degree, .lag_s = 0.1};
  VehicleConfig vehicle;
  vehicle.name = "kinematic";
  vehicle.length_m = 5.3;
  vehicle.rudder = vehicle.stern_planes = vehicle.bow_planes = surface;
  vehicle.propeller.advance_m = 0.012;
  vehicle.propeller.limit_radps = 2500 * units::revolution_per_minute;
  vehicle.propeller.lag_s = 0.1;
  return vehicle;
}

}  // namespace drydock::rig_config
