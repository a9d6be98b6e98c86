#pragma once

#include <string_view>

#include "rig_config/mission.hpp"

namespace drydock::rig_config {

/// The value of SteeringConfig::from for actuators that take orders from nodes of a bus.
inline constexpr std::string_view wires = "wires";

inline bool steered_over_wires(const MissionConfig& mission) {
  return mission.steering && mission.steering->from == wires;
}

}  // namespace drydock::rig_config
