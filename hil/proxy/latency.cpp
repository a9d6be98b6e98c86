#include "hil/proxy/latency.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::proxy {

void Latency::add(std::chrono::nanoseconds took) {
  const double us = std::max(1.0, static_cast<double>(took.count()) * 1e-3);
  const auto bucket = static_cast<std::size_t>(std::log2(us) * steps_per_octave);
  ++buckets_.at(std::min(bucket, buckets_.size() - 1));
  ++count_;
}

std::chrono::nanoseconds Latency::percentile(double share) const {
  const double wanted = share * static_cast<double>(count_);
  std::uint64_t so_far = 0;
  for (std::size_t i = 0; i < buckets_.size(); ++i) {
    so_far += buckets_.at(i);
    if (so_far > 0 && static_cast<double>(so_far) >= wanted)
      return std::chrono::nanoseconds{
          std::llround(1e3 * std::exp2(static_cast<double>(i + 1) / steps_per_octave))};
  }
  return {};
}

}  // namespace drydock::proxy
