#pragma once

#include <span>
#include <vector>

namespace drydock::campaign {

/// The rank of each value from 1; equal values share the mean of theirs.
std::vector<double> ranks_of(std::span<const double> values);

}  // namespace drydock::campaign
