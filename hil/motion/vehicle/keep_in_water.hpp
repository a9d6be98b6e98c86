#pragma once

#include "hil/motion/vehicle/vehicle_motion.hpp"

namespace drydock::motion {

/// Puts a vehicle back that a step of the bed, as a raster may have it, buried all the same: what
/// add_contact() holds stays within 0.1 m.
void keep_in_water(VehicleState& state, const ocean::Ocean& ocean);

}  // namespace drydock::motion
