#include "estimators/vehicle/vehicle.hpp"

#include <stdexcept>

#include "estimators/hydrodynamics/coefficient_table.hpp"

namespace drydock::vehicle {

hydrodynamics::Vehicle dimensional(const rig_config::VehicleConfig& config) {
  hydrodynamics::Vehicle vehicle;
  const auto& inertia = config.moments_of_inertia_kgm2;
  vehicle.body = {.mass = config.mass_kg,
                  .weight = config.weight_n,
                  .buoyancy = config.buoyancy_n,
                  .z_G = config.z_G_m,
                  .z_B = config.z_B_m,
                  .moments_of_inertia = {inertia[0], inertia[1], inertia[2]}};
  for (const auto& [axis, name, prime] : config.coefficients) {
    const auto* entry = hydrodynamics::find_coefficient(axis, name);
    if (!entry) throw std::invalid_argument("there is no coefficient " + axis + " " + name);
    vehicle.coefficients.*entry->member =
        prime *
        hydrodynamics::prime_unit(entry->length_power, config.water_density_kgm3, config.length_m);
  }
  return vehicle;
}

}  // namespace drydock::vehicle
