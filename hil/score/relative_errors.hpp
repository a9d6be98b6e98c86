#pragma once

#include "hil/score/errors.hpp"

namespace drydock::score {

/// The relative pose error: of each pose and the one that comes nearest to `interval` later, if it
/// is within rpe_tolerance.
void add_relative_errors(const std::vector<Pair>& pairs, std::chrono::nanoseconds interval,
                         Errors& errors);

}  // namespace drydock::score
