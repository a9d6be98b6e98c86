#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::validity {

using measurement::Stamp;

/// Which sample each measurement was made of, by index; empty: none is left for it. Both in time
/// order; samples may have been lost, measurements not made up. Of all assignments that keep the
/// order and leave the fewest measurements alone it is the one with the least sum of |valid_at -
/// sampled_at|: so a stall that brings several at once shows as their error, and is not hidden by
/// a neighbour. A constant error beyond half a period would be.
std::vector<std::optional<std::size_t>> pair(std::span<const Stamp> valid_at,
                                             std::span<const Stamp> sampled_at);

}  // namespace drydock::validity
