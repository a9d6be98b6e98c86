#pragma once

#include <vector>

#include "hil/emulate/condition.hpp"
#include "hil/fault/schedule/schedule.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

/// What the faults in force make of a device of a kind from within; with none of them it is sound.
/// Of two of a kind the later one in the list holds.
emulate::Condition condition_under(const std::vector<InForce>& faults, rig_config::DeviceKind kind);

}  // namespace drydock::fault
