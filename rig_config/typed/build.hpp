#pragma once

#include <array>
#include <string_view>

#include "rig_config/rig.hpp"
#include "rig_config/toml/node.hpp"
#include "rig_config/vehicle.hpp"

/// From checked documents to typed values: units become SI, absent keys keep their defaults.
namespace drydock::rig_config {

/// As rig and sensor files name them, in the order of DeviceKind.
inline constexpr std::array device_kinds{"dvl", "emlog", "gnss", "imu", "depth", "actuator"};
inline std::string_view name_of(DeviceKind kind) {
  return device_kinds.at(static_cast<std::size_t>(kind));
}

/// The blocks [[expect]] of a rig, in their order.
std::vector<ExpectConfig> build_expects(const Node& root);

/// The blocks [[fault]] of a rig, mission or fault file, in their order.
std::vector<FaultConfig> build_faults(const Node& root, const std::string& file);

/// All of a rig but its mission and the errors that stand in sensor files.
Rig build_rig(const Node& root, const std::string& file);

/// All of a mission but its vehicle, which has a file of its own. `file`: the mission's, for what
/// is named beside it.
MissionConfig build_mission(const Node& root, const std::string& file);
OceanConfig build_ocean(const Node& table, const std::string& mission_file);

VehicleConfig build_vehicle(const Node& root);

/// `[device.emulate]` but for what may stand in sensor files; `rig_file` for what is named beside
/// it.
EmulateConfig build_emulate(const Node& table, const std::string& rig_file);

/// Takes the keys of a kind from `[device.emulate]` or from that kind's table in a sensor file;
/// keys that are absent change nothing.
void read_errors(const Node& table, DeviceKind kind, EmulateConfig& into);

}  // namespace drydock::rig_config
