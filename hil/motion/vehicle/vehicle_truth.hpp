#pragma once

#include "hil/motion/truth.hpp"
#include "hil/motion/vehicle/vehicle_motion.hpp"

namespace drydock::motion {

/// The truth of a vehicle in a state, without its actuators. `rate` and `acceleration_ned` (m/s2)
/// are those of the state, `t_s` counts from the mission's start.
Truth truth_of(const VehicleState& state, const VehicleRate& rate,
               const Eigen::Vector3d& acceleration_ned, const ocean::Ocean& ocean, double t_s);

}  // namespace drydock::motion
