#pragma once

#include <array>
#include <chrono>
#include <cstdint>

namespace drydock::proxy {

/// A histogram of durations. Its buckets are an eighth of an octave wide, from 1 us to an hour, so
/// the memory does not grow with time.
class Latency {
 public:
  void add(std::chrono::nanoseconds took);

  std::uint64_t count() const { return count_; }
  /// Upper edge of the bucket that reaches this share of all values; 0 if there are none.
  std::chrono::nanoseconds percentile(double share) const;

 private:
  static constexpr std::size_t steps_per_octave = 8;
  std::array<std::uint64_t, 32 * steps_per_octave> buckets_{};
  std::uint64_t count_ = 0;
};

}  // namespace drydock::proxy
