#pragma once

#include <cmath>
#include <optional>

#include "hil/sensor/disturbance.hpp"

namespace drydock::emulate {

using measurement::Stamp;

/// A device's clock against bench time.
struct DeviceClock {
  std::chrono::nanoseconds step{0};
  double rate = 0;  ///< too fast by this share
  Stamp since{};    ///< from when on

  Stamp shows(Stamp at) const {
    return at + step +
           std::chrono::nanoseconds{std::llround(rate * static_cast<double>((at - since).count()))};
  }
};

/// What faults make of an emulated device from within: its sensors, its clock, what is around it.
/// As it stands here a device is sound. docs/use/faults.md
struct Condition {
  sensor::Disturbance primary, secondary;
  std::optional<Stamp> stuck_at;  ///< it goes on measuring this moment
  double times_fewer = 1;         ///< samples than its rate says
  DeviceClock clock;
  bool bottom_lost = false;
  double blocked_below_rad = -2;  ///< no satellite is seen under such an elevation
  double antenna_gain_db = 0;
  bool refuses = false;  ///< to be set
  struct Heat {
    Stamp shuts_down_at{};
  };
  std::optional<Heat> hot;  ///< of a DVL out of the water
};

}  // namespace drydock::emulate
