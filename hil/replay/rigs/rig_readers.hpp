#pragma once

#include <string>
#include <vector>

#include "hil/replay/rigs/capture_parts.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// A device of a rig as the reader of a capture.
struct RigReader {
  std::string name;
  bool on_bus = false;
  decode::ReplayOptions how;  ///< its driver, as the rig describes it
};

/// Of each device of the rig. `how`: as RigCaptures has it. Throws std::runtime_error with one line
/// if a driver cannot be made.
std::vector<RigReader> readers_of(const rig_config::Rig& rig, const decode::ReplayOptions& how);

/// True if its driver makes measurements of the part.
bool understands(const RigReader& reader, const CapturePart& part);

}  // namespace drydock::replay
