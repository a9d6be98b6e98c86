#pragma once

#include "rig_config/rig.hpp"

namespace drydock::bench {

/// Plays the emulated devices of a rig on their ptys and buses, for `drydock drive` or any other
/// program. `duration_s` 0: until Ctrl-C. Returns 0, or 1 if a line lost messages.
int emulate(const rig_config::Rig& rig, double duration_s);

}  // namespace drydock::bench
