#pragma once

#include <vector>

#include "hil/emulate/condition.hpp"
#include "hil/fault/schedule/schedule.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

/// The internal condition of a device of this kind under the faults in force. Without a fault it is
/// sound. If two faults set the same value, the later one in the list counts.
emulate::Condition condition_under(const std::vector<InForce>& faults, rig_config::DeviceKind kind);

}  // namespace drydock::fault
