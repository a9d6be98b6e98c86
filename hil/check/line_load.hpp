#pragma once

#include "rig_config/load.hpp"

namespace drydock::check {

/// The emulated devices of a rig that send more than their serial line carries at its baud rate,
/// measured in virtual time with the vehicle at the surface, where a receiver has most to say. The
/// rig runs, and loses what does not fit: these are warnings. The rig must be sound.
rig_config::Problems overloaded_lines(const rig_config::Rig& rig);

}  // namespace drydock::check
