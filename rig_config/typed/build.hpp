#pragma once

#include <string>

#include "rig_config/load.hpp"
#include "rig_config/rig.hpp"
#include "rig_config/toml/node.hpp"
#include "rig_config/vehicle.hpp"

/// Converts checked documents to typed values. Units become SI; absent keys keep their defaults.
namespace drydock::rig_config {

/// In words: the sensor file at `path` says nothing of this kind.
inline std::string no_table(const std::string& path, DeviceKind kind) {
  return path + " has no table [" + std::string(to_string(kind)) + "]";
}

/// The blocks [[expect]] of a rig, in their order.
std::vector<ExpectConfig> build_expects(const Node& root);

/// The blocks [[fault]] of a rig, mission or fault file, in their order.
std::vector<FaultConfig> build_faults(const Node& root, const std::string& file);

/// The rig without its mission and without the errors from sensor files.
Rig build_rig(const Node& root, const std::string& file);

/// The mission without its vehicle, which has its own file. `file`: the path of the mission; other
/// paths are relative to it.
MissionConfig build_mission(const Node& root, const std::string& file);
OceanConfig build_ocean(const Node& table, const std::string& mission_file);

VehicleConfig build_vehicle(const Node& root);
/// The same for a vehicle file with blocks [[thruster]].
ThrusterVehicleConfig build_thruster_vehicle(const Node& root);
inline bool has_thrusters(const Node& vehicle_file) { return vehicle_file.find("thruster"); }
/// What is wrong with such a file where fins must steer. Empty: the file has none.
Problems fins_are_missing(const Node& vehicle_file, const std::string& path);

/// `[device.emulate]` without the keys that sensor files may have. Paths are relative to
/// `rig_file`.
EmulateConfig build_emulate(const Node& table, const std::string& rig_file);

/// Reads the keys of a kind from `[device.emulate]` or from the table of this kind in a sensor
/// file. Absent keys change nothing.
void read_errors(const Node& table, DeviceKind kind, EmulateConfig& into);

}  // namespace drydock::rig_config
