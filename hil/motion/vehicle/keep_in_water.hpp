#pragma once

#include "hil/motion/vehicle/vehicle_motion.hpp"

namespace drydock::motion {

/// Stops a vehicle that would leave the water or sink into the bed.
void keep_in_water(VehicleState& state, const ocean::Ocean& ocean);

}  // namespace drydock::motion
