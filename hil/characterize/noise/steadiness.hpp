#pragma once

#include <span>

namespace drydock::characterize {

/// Whether readings were of one unchanging input, which an Allan deviation takes for granted.
struct Steadiness {
  bool steady = true;
  double change = 0;  ///< largest departure of a second's mean from the median of all of them
};

/// Seconds move when more than 1 % of them lie further from their median than `change` and than six
/// times the scatter from each second to the next. A steady turn or constant speed is one input.
Steadiness steadiness_of(std::span<const double> readings, double period_s, double change);

}  // namespace drydock::characterize
