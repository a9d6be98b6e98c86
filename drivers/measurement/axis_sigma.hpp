#pragma once

#include <numbers>
#include <optional>

#include "drivers/measurement/measurement.hpp"

namespace drydock::measurement {

/// One sigma of a fix to the north, and likewise to the east, m: its radial accuracy holds both.
/// Empty: the receiver does not tell it.
inline std::optional<double> axis_sigma_m(const GnssFix& fix) {
  if (!fix.horizontal_accuracy_m) return {};
  return *fix.horizontal_accuracy_m / std::numbers::sqrt2;
}

}  // namespace drydock::measurement
