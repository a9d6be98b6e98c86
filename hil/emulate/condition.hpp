#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "hil/sensor/disturbance.hpp"
#include "rig_config/fault.hpp"

namespace drydock::emulate {

using measurement::Stamp;
using rig_config::FaultKind;

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

/// A fault that is in force.
struct Trouble {
  FaultKind kind{};
  Stamp since{};
  double amount = 0;  ///< in the unit of the word's key
};

/// The internal effects of faults on an emulated device: its sensors, its clock, its surroundings.
/// By default the device is sound. docs/use/faults.md
struct Condition {
  sensor::Disturbance primary, secondary;
  std::optional<Stamp> stuck_at;  ///< the device keeps measuring this moment
  double times_fewer = 1;         ///< factor by which fewer samples are sent
  DeviceClock clock;
  std::vector<Trouble> troubles;  ///< every fault of the device; the later one of a kind counts

  /// For a fault that only some devices know: bottom_lost, hot, nak, ... Null: not in force.
  const Trouble* under(FaultKind kind) const {
    const auto found = std::find_if(troubles.rbegin(), troubles.rend(),
                                    [&](const Trouble& each) { return each.kind == kind; });
    return found == troubles.rend() ? nullptr : &*found;
  }
};

}  // namespace drydock::emulate
