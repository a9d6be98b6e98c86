#pragma once

#include "rig_config/load.hpp"

namespace drydock::check {

/// Problems of the drivers and links of a rig.
rig_config::Problems check_devices(const rig_config::Rig& rig);

/// Links that are real hardware, which has no virtual time.
rig_config::Problems check_virtual_time(const rig_config::Rig& rig);

bool is_emulated(const rig_config::DeviceConfig& device);

}  // namespace drydock::check
