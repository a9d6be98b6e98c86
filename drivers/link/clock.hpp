#pragma once

#include <chrono>

#include "drivers/measurement/stamp.hpp"

namespace drydock::link {

using measurement::Stamp;

/// UTC at the first call plus the time that the steady clock has counted since. Emulated devices
/// use this time: it does not jump when the host's clock is changed.
Stamp steady_now();

/// Detects when somebody changes the host's clock.
class ClockWatch {
 public:
  static constexpr std::chrono::milliseconds smallest_step{100};  ///< a smaller change is slewing

  /// The jump of now() since the last call. Zero if it runs like the steady clock.
  std::chrono::nanoseconds step();
  std::chrono::nanoseconds step(Stamp utc, std::chrono::nanoseconds steady);

 private:
  bool begun_ = false;
  std::chrono::nanoseconds offset_{0};  ///< UTC minus the steady clock
};

}  // namespace drydock::link
