#pragma once

#include <cstdint>

#include "estimators/hydrodynamics/vehicle.hpp"

namespace drydock::study {

/// A vehicle with random coefficients: each one is multiplied by its own factor from N(1, sigma^2).
/// All factors are drawn again until the mass matrix is valid (is_mass()). Mass, weight, buoyancy,
/// their centres and the moments of inertia do not change. The same (seed, sigma) gives the same
/// vehicle. Throws std::invalid_argument for a negative sigma and for a vehicle without mass.
hydrodynamics::Vehicle perturbed(const hydrodynamics::Vehicle& vehicle, std::uint64_t seed,
                                 double sigma);

}  // namespace drydock::study
