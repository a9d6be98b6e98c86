#include "drivers/measurement/units.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

SurfaceConfig build_surface(const Node& table) {
  SurfaceConfig surface;
  read(table, "limit_deg", surface.limit_rad, units::degree);
  surface.rate_limit_radps = read_if(table, "rate_limit_degps", units::degree);
  read(table, "lag_s", surface.lag_s);
  return surface;
}

PropellerConfig build_propeller(const Node& table) {
  PropellerConfig propeller;
  read(table, "advance_m", propeller.advance_m);
  read(table, "limit_rpm", propeller.limit_radps, units::revolution_per_minute);
  propeller.rate_limit_radps2 = read_if(table, "rate_limit_rpmps", units::revolution_per_minute);
  read(table, "lag_s", propeller.lag_s);
  return propeller;
}

}  // namespace

VehicleConfig build_vehicle(const Node& root) {
  VehicleConfig vehicle;
  const Node& table = *root.find("vehicle");
  read(table, "name", vehicle.name);
  read(table, "length_m", vehicle.length_m);
  read(table, "water_density_kgm3", vehicle.water_density_kgm3);
  read(table, "mass_kg", vehicle.mass_kg);
  read(table, "weight_n", vehicle.weight_n);
  read(table, "buoyancy_n", vehicle.buoyancy_n);
  read(table, "z_G_m", vehicle.z_G_m);
  read(table, "z_B_m", vehicle.z_B_m);
  read(table, "moments_of_inertia_kgm2", vehicle.moments_of_inertia_kgm2);
  vehicle.rudder = build_surface(*root.find("rudder"));
  vehicle.stern_planes = build_surface(*root.find("stern_planes"));
  vehicle.bow_planes = build_surface(*root.find("bow_planes"));
  vehicle.propeller = build_propeller(*root.find("propeller"));
  for (const char* axis : {"X", "Y", "Z", "K", "M", "N"})
    for (const auto& [name, value] : root.find(axis)->members)
      vehicle.coefficients.push_back({axis, name, value.number});
  return vehicle;
}

}  // namespace drydock::rig_config
