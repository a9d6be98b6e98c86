#pragma once

#include <optional>

#include "estimators/roll/antenna.hpp"
#include "estimators/roll/epoch.hpp"

namespace drydock::roll {

/// Where a reported power must have been before it was rounded or lost; both the same: it is exact.
struct Interval {
  double low, high;
};

/// Eq. (30), (31). Nothing where a lost signal says nothing.
std::optional<Interval> interval_of(const AntennaOptions& antenna, const Signal& signal);

struct Moments {
  double log_probability = 0;
  double shift = 0;   ///< of the mean, in sigmas
  double shrink = 0;  ///< of the variance, as a share of it
};

/// Of a standard normal variable that turns out to lie between `z`, eq. (32): its mean, and what
/// is missing from its variance of 1. The interval must not be further out than 30 or so. An exact
/// one has the density for its probability, but for a constant.
Moments within(const Interval& z);

}  // namespace drydock::roll
