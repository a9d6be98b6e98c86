#pragma once

#include "rig_config/load.hpp"

namespace drydock::check {

/// How a rig is to be used.
enum class Use : std::uint8_t {
  any,        ///< it must start in one way at least: in virtual time, or in real time
  lockstep,   ///< in virtual time
  real_time,  ///< by the clock of this machine
  emulation   ///< in real time, with at least one emulated device
};

/// Everything in a loaded rig that stops its devices, emulated devices, mission or estimators from
/// starting. Opens no port and no bus.
rig_config::Problems check_rig(const rig_config::Rig& rig, Use use = Use::any);

/// A rig that can be used so, or everything that stands against it. All commands that take a rig
/// load it here.
rig_config::Loaded<rig_config::Rig> load_sound_rig(const std::string& path, Use use = Use::any);

/// Everything in a mission that stops its vehicle from moving.
rig_config::Problems check_mission(const rig_config::MissionConfig& mission);

}  // namespace drydock::check
