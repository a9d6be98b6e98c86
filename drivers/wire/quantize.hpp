#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

namespace drydock::wire {

/// `value` as a wire integer in steps of `unit`: the nearest step, limited to the range of the
/// integer.
template <std::integral T>
T quantize(double value, double unit) {
  constexpr double lowest = static_cast<double>(std::numeric_limits<T>::min());
  constexpr double highest = static_cast<double>(std::numeric_limits<T>::max());
  return static_cast<T>(std::llround(std::clamp(value / unit, lowest, highest)));
}

}  // namespace drydock::wire
