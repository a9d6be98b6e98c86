#pragma once

#include "hil/motion/leg_profile.hpp"
#include "hil/motion/smooth_step.hpp"

/// Changes of heading by time t of a leg: rad, rad/s.
namespace drydock::motion {

/// The rate of turn rises to `rate_radps` on the window's first ramp, goes over to `end_rate_radps`
/// between the ramps and falls to zero on the last; each of the three is a quintic.
Varying spiral(const rig_config::LegConfig& leg, const Window& window, double t);

/// To starboard by `amplitude_rad` (to port where negative), to the other side after half a
/// `period_s`, and so on; the last turn brings the heading back by the end of the leg. Each is a
/// quintic that turns at `rate_radps` at most.
Varying zigzag(const rig_config::LegConfig& leg, double t);

/// Whether the turns of a zigzag end before the next begins, and there are two halves or more.
bool turns_fit(const rig_config::LegConfig& leg);

}  // namespace drydock::motion
