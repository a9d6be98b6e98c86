#pragma once

#include "rig_config/rig.hpp"

namespace drydock::cli {

/// Runs the drivers of a rig: links in, measurements and health on the bus. `duration_s` 0: until
/// Ctrl-C. Returns 0, or 1 when a device was not streaming at the end.
int drive(const rig_config::Rig& rig, double duration_s);

}  // namespace drydock::cli
