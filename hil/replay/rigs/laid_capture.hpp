#pragma once

#include "hil/replay/rigs/other_rig.hpp"
#include "hil/replay/rigs/rig_captures.hpp"

namespace drydock::replay {

/// Puts captures in the place of the links of a rig: each device gets a `file:` link to its part
/// (part_choice.hpp). What nobody reads and what the rig has besides is left out and noted. Throws
/// std::runtime_error with one line if nothing fits.
OtherRig lay(rig_config::Rig rig, const RigCaptures& captures);

}  // namespace drydock::replay
