#pragma once

#include <optional>

#include "estimators/roll/antenna.hpp"
#include "estimators/roll/epoch.hpp"

namespace drydock::roll {

/// The range of a power before the receiver rounded or lost it. Equal limits: it is exact.
struct Interval {
  double low, high;
};

/// Eq. (30), (31). Empty for a lost signal if the antenna has no tracking limit.
std::optional<Interval> interval_of(const AntennaOptions& antenna, const Signal& signal);

struct Moments {
  double log_probability = 0;
  double shift = 0;   ///< shift of the mean, in sigmas
  double shrink = 0;  ///< reduction of the variance, relative to it
};

/// Eq. (32): the mean of a standard normal variable that lies within `z`, and the reduction of its
/// variance of 1. The interval must not be further out than about 30. For an exact value the
/// "probability" is the density, without its constant factor.
Moments within(const Interval& z);

}  // namespace drydock::roll
