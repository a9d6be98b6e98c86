#pragma once

#include "hil/motion/leg_profile.hpp"
#include "hil/motion/smooth_step.hpp"

/// Changes of heading at time t of a leg: rad, rad/s.
namespace drydock::motion {

/// The rate of turn rises to `rate_radps` on the window's first ramp, changes to `end_rate_radps`
/// between the ramps and falls to zero on the last ramp. Each part is a quintic.
Varying spiral(const rig_config::LegConfig& leg, const Window& window, double t);

/// The heading turns to starboard by `amplitude_rad` (to port if negative), to the other side after
/// half a `period_s`, and so on. The last turn brings it back at the end of the leg. Each turn is a
/// quintic with at most `rate_radps`.
Varying zigzag(const rig_config::LegConfig& leg, double t);

/// True if each turn of a zigzag ends before the next begins, and there are at least two halves.
bool turns_fit(const rig_config::LegConfig& leg);

}  // namespace drydock::motion
