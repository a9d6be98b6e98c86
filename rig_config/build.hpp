#pragma once

#include "rig_config/node.hpp"
#include "rig_config/rig.hpp"
#include "rig_config/vehicle.hpp"

/// From checked documents to typed values: units become SI, absent keys keep their defaults.
namespace drydock::rig_config {

/// All of a rig but its mission and the errors that stand in sensor files.
Rig build_rig(const Node& root, const std::string& file);

/// All of a mission but its vehicle, which has a file of its own. `file`: the mission's, for what
/// is named beside it.
MissionConfig build_mission(const Node& root, const std::string& file);
OceanConfig build_ocean(const Node& table, const std::string& mission_file);

VehicleConfig build_vehicle(const Node& root);

/// `[device.emulate]` but for the errors of the sensor; `rig_file` for what is named beside it.
EmulateConfig build_emulate(const Node& table, const std::string& rig_file);

/// Takes the error keys of a kind from `[device.emulate]` or from that kind's table in a sensor
/// file; keys that are absent change nothing.
void read_errors(const Node& table, DeviceKind kind, EmulateConfig& into);

}  // namespace drydock::rig_config
