#pragma once

#include <string>
#include <vector>

#include "hil/motion/make_trajectory.hpp"
#include "rig_config/rig.hpp"

namespace drydock::summary {

/// The devices of the rig that this program emulates.
std::vector<rig_config::DeviceConfig> emulated_devices(const rig_config::Rig& rig);

/// True if every device is emulated: no program on the bus can take the truth for a measurement of
/// the world.
bool no_real_device(const rig_config::Rig& rig);

/// True if the inertial measurements of the estimators come from the emulated truth.
bool truth_for_estimators(const rig_config::Rig& rig);

/// One line per automatic CAN bus: what it became on this machine.
std::vector<std::string> can_notes(const rig_config::Rig& rig);

}  // namespace drydock::summary
