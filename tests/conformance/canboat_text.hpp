#pragma once

#include <string>
#include <string_view>

namespace drydock::conformance {

/// Converts lines of canboat's two text forms to lines of `candump -L`, which drydock reads:
///  TIME,PRIORITY,PGN,SOURCE,DESTINATION,SIZE,hex,hex,...
///  ASSSSS.DDD SSDDP PGN HEX                       (Actisense N2K ASCII)
/// A message of more than 8 bytes is divided into the frames of a fast packet. Other lines are
/// omitted.
std::string candump_of(std::string_view text);

}  // namespace drydock::conformance
