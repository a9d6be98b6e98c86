#pragma once

#include <cstdint>

namespace drydock::diagnosis {

/// Where the antenna of a receiver is. Under water it sees no satellite, and that is no fault.
/// Where nobody knows, a sky that went away altogether may be a dive.
enum class Antenna : std::uint8_t { unknown, dry, wet };

}  // namespace drydock::diagnosis
