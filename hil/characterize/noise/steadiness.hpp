#pragma once

#include <span>

namespace drydock::characterize {

/// Whether the input was constant. An Allan deviation is only meaningful for a constant input.
struct Steadiness {
  bool steady = true;
  double change = 0;  ///< largest difference between a second's mean and the median of all
};

/// The input moved if more than 1 % of the seconds are further from the median than `change` and
/// than six times the scatter from one second to the next. A steady turn or a constant speed is a
/// constant input.
Steadiness steadiness_of(std::span<const double> readings, double period_s, double change);

}  // namespace drydock::characterize
