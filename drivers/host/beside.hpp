#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "drivers/host/follower.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// Makes a follower of the drivers that tells the others what it learns, as the diagnostician does.
/// It comes from the program, since it may know estimators. Rig, devices and followers outlive it.
using Beside = std::function<std::shared_ptr<Follower>(
    const rig_config::Rig& rig, std::vector<const device::Device*> devices, Follower& others)>;

}  // namespace drydock::host
