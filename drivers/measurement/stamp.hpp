#pragma once

#include <chrono>
#include <cstdint>

namespace drydock::measurement {

/// Clock of every stamp: nanoseconds of UTC since 1970 on the bench, virtual time in lockstep.
/// It has no now(): only the shells read a clock.
struct BenchClock {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = std::chrono::nanoseconds;
  using time_point = std::chrono::time_point<BenchClock, duration>;
  static constexpr bool is_steady = false;
};

using Stamp = BenchClock::time_point;

constexpr Stamp stamp_from_ns(std::int64_t ns) { return Stamp{std::chrono::nanoseconds{ns}}; }

constexpr double seconds(std::chrono::nanoseconds duration) {
  return std::chrono::duration<double>(duration).count();
}

constexpr std::chrono::nanoseconds from_seconds(double s) {
  return std::chrono::nanoseconds{static_cast<std::int64_t>(s * 1e9 + (s < 0 ? -0.5 : 0.5))};
}

}  // namespace drydock::measurement
