#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::survey {

/// Rate of arrivals: the number of intervals divided by their total time.
struct Arrivals {
  std::uint64_t count = 0;
  measurement::Stamp first{}, last{};

  void add(measurement::Stamp at) {
    if (count++ == 0) first = at;
    last = at;
  }
  void add(const Arrivals& others) {
    first = count == 0 ? others.first : std::min(first, others.first);
    last = count == 0 ? others.last : std::max(last, others.last);
    count += others.count;
  }
  /// Empty for a single arrival, or without times.
  std::optional<double> rate_hz() const {
    if (count < 2 || last <= first) return {};
    return static_cast<double>(count - 1) / measurement::seconds(last - first);
  }
};

}  // namespace drydock::survey
