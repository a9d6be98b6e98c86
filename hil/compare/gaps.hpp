#pragma once

#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::compare {

/// Times between estimates that may be used. A gap is longer than three times the median of them.
struct Gaps {
  std::uint64_t count = 0;
  double longest_s = 0;  ///< of all times between two estimates; 0: fewer than two
};

/// `valid_at` in the order of time.
Gaps gaps_of(const std::vector<measurement::Stamp>& valid_at);

}  // namespace drydock::compare
