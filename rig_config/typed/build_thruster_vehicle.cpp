#include "drivers/measurement/units.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

template <std::size_t N>
void read_row(const Node& table, const char* key, std::array<double, N>& into) {
  const Node* row = table.find(key);
  for (std::size_t i = 0; i < N; ++i) into[i] = row->items[i].number;
}

ThrusterConfig build_thruster(const Node& table) {
  ThrusterConfig thruster;
  read(table, "name", thruster.name);
  read_row(table, "position_m", thruster.position_m);
  read_row(table, "direction", thruster.direction);
  read(table, "ahead_n", thruster.ahead_n);
  read(table, "astern_n", thruster.astern_n);
  read(table, "exponent", thruster.exponent);
  read(table, "dead_band", thruster.dead_band);
  read(table, "lag_s", thruster.lag_s);
  read(table, "limit_rpm", thruster.limit_radps, units::revolution_per_minute);
  return thruster;
}

}  // namespace

ThrusterVehicleConfig build_thruster_vehicle(const Node& root) {
  ThrusterVehicleConfig vehicle;
  const Node& table = *root.find("vehicle");
  read(table, "name", vehicle.name);
  read(table, "mass_kg", vehicle.mass_kg);
  read(table, "weight_n", vehicle.weight_n);
  read(table, "buoyancy_n", vehicle.buoyancy_n);
  read(table, "z_G_m", vehicle.z_G_m);
  read(table, "z_B_m", vehicle.z_B_m);
  read_row(table, "moments_of_inertia_kgm2", vehicle.moments_of_inertia_kgm2);
  const Node& hull = *root.find("hull");
  read_row(hull, "added_mass", vehicle.added_mass);
  read_row(hull, "linear_damping", vehicle.linear_damping);
  read_row(hull, "quadratic_damping", vehicle.quadratic_damping);
  for_each_table(root, "thruster", [&](const Node& thruster, std::size_t) {
    vehicle.thrusters.push_back(build_thruster(thruster));
  });
  return vehicle;
}

Problems fins_are_missing(const Node& vehicle_file, const std::string& path) {
  const Node* thrusters = vehicle_file.find("thruster");
  if (!thrusters) return {};
  return {{path, thrusters->at.line, thrusters->at.column, "/thruster",
           "this vehicle has thrusters; here one with rudder, planes and propeller is needed"}};
}

}  // namespace drydock::rig_config
