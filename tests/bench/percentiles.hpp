#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace drydock::bench {

struct Percentiles {
  double p50 = 0, p99 = 0;
};

/// Zero if there are no values.
inline Percentiles percentiles_of(std::vector<double> values) {
  std::ranges::sort(values);
  if (values.empty()) return {};
  const auto at = [&](std::size_t percent) { return values[values.size() * percent / 100]; };
  return {at(50), at(99)};
}

}  // namespace drydock::bench
