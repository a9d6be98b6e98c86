#pragma once

#include <vector>

#include "estimators/external/hello.hpp"
#include "rig_config/rig.hpp"

namespace drydock::setup {

/// The devices of a rig, as programs outside are told them.
std::vector<external::Hello::Device> told_devices(const rig_config::Rig& rig);

}  // namespace drydock::setup
