#pragma once

#include <chrono>

#include "drivers/measurement/stamp.hpp"

namespace drydock::link {

using measurement::Stamp;

/// UTC as it was at the first call, and what the steady clock has counted since: the time of what
/// is emulated, which does not jump when the host's clock is set.
Stamp steady_now();

/// Sees when somebody sets the host's clock.
class ClockWatch {
 public:
  static constexpr std::chrono::milliseconds smallest_step{100};  ///< less is slewing

  /// How far now() has jumped since the last call; zero: it runs as the steady clock does.
  std::chrono::nanoseconds step();
  std::chrono::nanoseconds step(Stamp utc, std::chrono::nanoseconds steady);

 private:
  bool begun_ = false;
  std::chrono::nanoseconds offset_{0};  ///< of UTC to the steady clock
};

}  // namespace drydock::link
