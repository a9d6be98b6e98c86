#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"
#include "rig_config/vehicle.hpp"

/// From a vehicle file's values to the equations of motion.
namespace drydock::vehicle {

/// Prime values times rho/2 L^n. Throws std::invalid_argument (one line) for a coefficient that the
/// equations do not have; the loader lets none through.
hydrodynamics::Vehicle dimensional(const rig_config::VehicleConfig& config);

}  // namespace drydock::vehicle
