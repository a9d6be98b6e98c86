#pragma once

#include "rig_config/vehicle.hpp"

namespace drydock::rig_config {

/// The actuators of a vehicle that takes orders and has no vehicle file: those of the NPS AUV II
/// (Healey and Lienard, 1993). It has no hull: its motion follows the actuators directly.
VehicleConfig kinematic_vehicle();

inline bool is_kinematic(const VehicleConfig& vehicle) { return vehicle.mass_kg == 0; }

}  // namespace drydock::rig_config
