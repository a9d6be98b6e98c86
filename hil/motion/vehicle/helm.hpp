#pragma once

#include <cstdint>

#include "hil/motion/vehicle/autopilot.hpp"

namespace drydock::motion {

inline constexpr std::int64_t voyage_step_ns = 10'000'000;
inline constexpr double voyage_step_s = 0.01;

/// What decides the commands of a vehicle.
class Helm {
 public:
  virtual ~Helm() = default;
  /// The command from a step until the next one. `state` is that of the step, `memory` that of the
  /// steps before it. The same step gets the same command each time.
  virtual Command command(std::int64_t step, const VehicleState& state,
                          AutopilotMemory& memory) const = 0;
};

}  // namespace drydock::motion
