#pragma once

#include "drivers/diagnosis/cause.hpp"

namespace drydock::diagnosis {

/// A sound device says so too: the bed may be out of range, and an antenna may be under water.
inline bool is_of_the_surroundings(Cause cause) {
  return cause == Cause::bottom_lost || cause == Cause::satellites_blocked;
}

}  // namespace drydock::diagnosis
