#pragma once

#include <string>
#include <string_view>

namespace drydock::conformance {

/// Lines of canboat's two text forms as lines of `candump -L`, which the product reads:
///   TIME,PRIORITY,PGN,SOURCE,DESTINATION,SIZE,hex,hex,...
///   ASSSSS.DDD SSDDP PGN HEX                       (Actisense N2K ASCII)
/// A message of more than 8 bytes is cut into the frames of a fast packet. Other lines are left
/// out.
std::string candump_of(std::string_view text);

}  // namespace drydock::conformance
