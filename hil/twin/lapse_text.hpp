#pragma once

#include <string>

#include "hil/twin/statistics.hpp"

namespace drydock::twin {

/// Blocks [[fault]] of a mission that begins at `start`: a device says nothing where the recorded
/// one said nothing for long, and a DVL has no bottom lock where the recorded one had none.
std::string lapse_text(const DeviceStatistics& statistics, const std::string& device,
                       rig_config::DeviceKind kind, measurement::Stamp start);

}  // namespace drydock::twin
