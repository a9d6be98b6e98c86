#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::validity {

using measurement::Stamp;

/// The index of the sample from which each measurement was made; empty: no sample is left for it.
/// Both are in time order. Samples may be lost; measurements are never invented. Of all assignments
/// that keep the order and leave the fewest measurements without a sample, it is the one with the
/// least sum of |valid_at - sampled_at|. If a stall brings several measurements at once, their
/// errors show it; they are not paired with neighbours. A constant error of more than half a period
/// stays hidden.
std::vector<std::optional<std::size_t>> pair(std::span<const Stamp> valid_at,
                                             std::span<const Stamp> sampled_at);

}  // namespace drydock::validity
