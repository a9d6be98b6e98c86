#pragma once

#include <array>
#include <chrono>
#include <cstdint>

namespace drydock::proxy {

/// How long things took, in buckets that are an eighth of an octave wide from 1 us to an hour: no
/// memory grows with a proxy's age.
class Latency {
 public:
  void add(std::chrono::nanoseconds took);

  std::uint64_t count() const { return count_; }
  /// Upper edge of the bucket in which that share of all is reached; 0 of none.
  std::chrono::nanoseconds percentile(double share) const;

 private:
  static constexpr std::size_t steps_per_octave = 8;
  std::array<std::uint64_t, 32 * steps_per_octave> buckets_{};
  std::uint64_t count_ = 0;
};

}  // namespace drydock::proxy
