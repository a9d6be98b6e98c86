#pragma once

#include "hil/motion/truth.hpp"

namespace drydock::motion {

/// The kinematic vehicle's actuator law: the steady settings that go with a motion, proportional to
/// its curvature and speed, within +-20 deg. The gains make the steady turn of the NPS AUV II
/// (rudder 10 deg: radius 29.4 m; propeller: speed 0.012 m per rad; Healey and Lienard, IEEE J.
/// Oceanic Eng. 18(3), 1993), and pitch curvature is steered alike by both planes. Fills in rudder,
/// planes and propeller from velocity_body and rate_body.
void set_actuators(Truth& truth);

}  // namespace drydock::motion
