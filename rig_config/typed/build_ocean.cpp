#include "drivers/measurement/units.hpp"
#include "rig_config/checks/checks.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

constexpr std::array bed_kinds{"plane", "slope", "raster"};
constexpr std::array water_kinds{"uniform", "layered", "standard"};
constexpr double zero_celsius_k = 273.15;

BedConfig build_bed(const Node& table, const std::string& mission_file) {
  BedConfig bed;
  bed.kind = named<BedKind>(table, bed_kinds);
  read(table, "depth_m", bed.depth_m);
  read(table, "gradient", bed.gradient);
  read(table, "downhill_deg", bed.downhill_rad, units::degree);
  if (const Node* file = table.find("file")) bed.file = beside(mission_file, file->text);
  if (const Node* unit = table.find("coordinates")) bed.in_metres = unit->text == "metres";
  if (const Node* values = table.find("values")) bed.elevations = values->text == "elevation";
  return bed;
}

TideConfig build_tide(const Node& table) {
  TideConfig tide;
  read(table, "period_s", tide.period_s);
  read(table, "phase_deg", tide.phase_rad, units::degree);
  read(table, "velocity_ned_mps", tide.velocity_ned_mps);
  return tide;
}

WaterConfig build_water(const Node& table) {
  WaterConfig water;
  if (table.find("kind")) water.kind = named<WaterKind>(table, water_kinds);
  read(table, "density_kgm3", water.density_kgm3);
  for_each_table(table, "layer", [&](const Node& layer, std::size_t) {
    water.density.push_back({layer.find("depth_m")->number, layer.find("density_kgm3")->number});
  });
  read(table, "surface_pressure_pa", water.surface_pressure_pa);
  if (const Node* celsius = table.find("temperature_degc"))
    water.temperature_k = celsius->number + zero_celsius_k;
  read(table, "salinity_ppt", water.salinity_ppt);
  return water;
}

}  // namespace

OceanConfig build_ocean(const Node& table, const std::string& mission_file) {
  OceanConfig ocean;
  if (const Node* bed = table.find("bed")) ocean.bed = build_bed(*bed, mission_file);
  for_each_table(table, "current", [&](const Node& knot, std::size_t) {
    CurrentConfig current;
    read(knot, "depth_m", current.depth_m);
    read(knot, "velocity_ned_mps", current.velocity_ned_mps);
    ocean.current.push_back(current);
  });
  if (const Node* tide = table.find("tide")) ocean.tide = build_tide(*tide);
  if (const Node* water = table.find("water")) ocean.water = build_water(*water);
  return ocean;
}

}  // namespace drydock::rig_config
