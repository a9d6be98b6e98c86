#pragma once

#include <string_view>

#include "rig_config/mission.hpp"

namespace drydock::rig_config {

/// The value of SteeringConfig::from for actuators that take orders from nodes of a bus.
inline constexpr std::string_view wires = "wires";

/// The value for joints that take orders from topics of the bus (DDS).
inline constexpr std::string_view dds = "dds";

/// The value for joints that take orders from a program on standard input and output.
inline constexpr std::string_view program = "program";

inline bool steered_over_dds(const MissionConfig& mission) {
  return mission.steering && mission.steering->from == dds;
}

inline bool steered_over_wires(const MissionConfig& mission) {
  return mission.steering && mission.steering->from == wires;
}

inline bool steered_by_program(const MissionConfig& mission) {
  return mission.steering && mission.steering->from == program;
}

/// True if the mission says where to go.
inline bool has_plan(const MissionConfig& mission) {
  return !mission.legs.empty() || !mission.waypoints.empty();
}

}  // namespace drydock::rig_config
