#include "hil/motion/vehicle/actuators.hpp"

namespace drydock::motion {

namespace {

ActuatorLimits surface_limits(const rig_config::SurfaceConfig& config) {
  ActuatorLimits limits{.lower = -config.limit_rad, .upper = config.limit_rad};
  if (config.rate_limit_radps) limits.rate = *config.rate_limit_radps;
  limits.lag_s = config.lag_s;
  return limits;
}

ActuatorLimits propeller_limits(const rig_config::PropellerConfig& config) {
  ActuatorLimits limits{.lower = 0, .upper = config.limit_radps};
  if (config.rate_limit_radps2) limits.rate = *config.rate_limit_radps2;
  limits.lag_s = config.lag_s;
  return limits;
}

}  // namespace

Actuators::Actuators(const rig_config::VehicleConfig& config, double speed_mps)
    : rudder_(surface_limits(config.rudder)),
      stern_planes_(surface_limits(config.stern_planes)),
      bow_planes_(surface_limits(config.bow_planes)),
      propeller_(propeller_limits(config.propeller), speed_mps / config.propeller.advance_m),
      advance_m_(config.propeller.advance_m) {}

void Actuators::step(const Command& command, double dt) {
  rudder_.step(command.delta_r, dt);
  stern_planes_.step(command.delta_s, dt);
  bow_planes_.step(command.delta_b, dt);
  propeller_.step(command.speed_mps / advance_m_, dt);
}

hydrodynamics::Control Actuators::control() const {
  return {rudder_.value(), stern_planes_.value(), bow_planes_.value(),
          advance_m_ * propeller_.value()};
}

rig_config::VehicleConfig with_ideal_actuators(rig_config::VehicleConfig config) {
  for (rig_config::SurfaceConfig* surface :
       {&config.rudder, &config.stern_planes, &config.bow_planes}) {
    surface->rate_limit_radps.reset();
    surface->lag_s = 0;
  }
  config.propeller.rate_limit_radps2.reset();
  config.propeller.lag_s = 0;
  return config;
}

}  // namespace drydock::motion
