#pragma once

#include "drivers/measurement/units.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::motion {

/// The rudder, or both planes, for a curvature of 1/m: the steady turn of the NPS AUV II below.
inline constexpr double rudder_per_curvature_m = 10 * units::degree * 29.4;

/// The actuator law of the kinematic vehicle: the steady settings for a motion, proportional to its
/// curvature and speed, within +-20 deg. The gains match the steady turn of the NPS AUV II (rudder
/// 10 deg: radius 29.4 m; propeller: speed 0.012 m per rad; Healey and Lienard, IEEE J. Oceanic
/// Eng. 18(3), 1993). Both planes share the pitch curvature equally. Sets rudder, planes and
/// propeller from velocity_body and rate_body.
void set_actuators(Truth& truth);

}  // namespace drydock::motion
