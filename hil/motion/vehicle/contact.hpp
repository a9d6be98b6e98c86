#pragma once

#include "hil/motion/vehicle/vehicle_motion.hpp"

namespace drydock::motion {

/// A hull that floats moves a little above the surface, up to this.
inline constexpr double highest_m = 0.25;

/// Adds the push of the bed, or of the water below a hull that leaves it, to the rate of a vehicle.
/// It acts along the vertical on all of the vehicle alike, never pulls, and grows smoothly from the
/// last centimetres on: the vehicle comes to rest at the bed and does not pass it. A vehicle that
/// is pressed on stays there. `t_s` counts from the mission's start.
void add_contact(const VehicleState& state, const ocean::Ocean& ocean, double t_s,
                 VehicleRate& rate);

}  // namespace drydock::motion
