#pragma once

#include <optional>
#include <vector>

#include "hil/replay/rigs/capture_parts.hpp"
#include "hil/replay/rigs/rig_captures.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// Which device of a rig reads which part of the captures: for each device the index of its part;
/// empty: none is for it. A device that a file was named for reads that file. Any other on a bus
/// reads the only bus; where there are more buses, and on a line, it reads the part that has the
/// name of the device or of its link, else the one of which its driver makes measurements. Throws
/// std::runtime_error with one line where several devices or parts fit equally.
std::vector<std::optional<std::size_t>> parts_of_devices(const rig_config::Rig& rig,
                                                         const RigCaptures& captures,
                                                         const std::vector<CapturePart>& parts);

}  // namespace drydock::replay
