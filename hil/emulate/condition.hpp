#pragma once

#include <cmath>
#include <optional>

#include "hil/sensor/disturbance.hpp"

namespace drydock::emulate {

using measurement::Stamp;

/// A device's clock compared with bench time.
struct DeviceClock {
  std::chrono::nanoseconds step{0};
  double rate = 0;  ///< relative; positive: too fast
  Stamp since{};    ///< when the drift began

  Stamp shows(Stamp at) const {
    return at + step +
           std::chrono::nanoseconds{std::llround(rate * static_cast<double>((at - since).count()))};
  }
};

/// The internal effects of faults on an emulated device: its sensors, its clock, its surroundings.
/// By default the device is sound. docs/use/faults.md
struct Condition {
  sensor::Disturbance primary, secondary;
  std::optional<Stamp> stuck_at;  ///< the device keeps measuring this moment
  double times_fewer = 1;         ///< factor by which fewer samples are sent
  DeviceClock clock;
  bool bottom_lost = false;
  double blocked_below_rad = -2;  ///< satellites below this elevation are hidden
  double antenna_gain_db = 0;
  bool refuses = false;  ///< refuses settings
  struct Heat {
    Stamp shuts_down_at{};
  };
  std::optional<Heat> hot;  ///< a DVL out of the water
};

}  // namespace drydock::emulate
