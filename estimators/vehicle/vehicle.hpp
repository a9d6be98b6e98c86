#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"
#include "rig_config/vehicle.hpp"

/// Converts the values of a vehicle file for the equations of motion.
namespace drydock::vehicle {

/// Multiplies prime values by rho/2 L^n. Throws std::invalid_argument (one line) for an unknown
/// coefficient; the loader refuses such a file before.
hydrodynamics::Vehicle dimensional(const rig_config::VehicleConfig& config);

}  // namespace drydock::vehicle
