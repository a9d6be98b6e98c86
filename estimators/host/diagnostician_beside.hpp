#pragma once

#include "drivers/host/beside.hpp"

namespace drydock::host {

/// Makes a diagnostician that watches the devices: host::Beside.
std::shared_ptr<Follower> diagnostician_beside(const rig_config::Rig& rig,
                                               std::vector<const device::Device*> devices,
                                               Follower& others);

}  // namespace drydock::host
