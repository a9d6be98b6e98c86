#pragma once

#include <cstdint>

#include "estimators/hydrodynamics/vehicle.hpp"

namespace drydock::study {

/// A vehicle as its coefficients may really be: each times a factor of its own, drawn from
/// N(1, sigma^2) and drawn again, all of them, until the mass matrix is one (is_mass()). Mass,
/// weight, buoyancy, their centres and the moments of inertia stay. The same (seed, sigma) gives
/// the same vehicle. Throws std::invalid_argument for a negative sigma and for a vehicle without
/// mass.
hydrodynamics::Vehicle perturbed(const hydrodynamics::Vehicle& vehicle, std::uint64_t seed,
                                 double sigma);

}  // namespace drydock::study
