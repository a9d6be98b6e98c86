#pragma once

#include <chrono>
#include <optional>

#include "drivers/diagnosis/monitors/host_lateness.hpp"

namespace drydock::host {

/// Whether this program wakes in time. It asks to be woken after `period`, again and again; each
/// look at the clock shows whether that time has passed. Sans-I/O.
class WakeTimes {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::nanoseconds period = diagnosis::HostLateness::asked_each;
  /// What timers of an idle computer need at most.
  static constexpr std::chrono::microseconds usual{500};

  explicit WakeTimes(Time now) : due_(now + period) {}

  /// For so long the program should have been awake already. Empty: it is in time. It is told once.
  std::optional<std::chrono::nanoseconds> look(Time now) {
    const auto late = now - due_;
    if (late < usual) return {};
    due_ = now + period;
    return late;
  }
  /// The next time at which to wake.
  Time ask(Time now) { return due_ = now + period; }

 private:
  Time due_;
};

}  // namespace drydock::host
