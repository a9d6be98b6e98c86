#pragma once

#include "drivers/device/vehicle_limits.hpp"

namespace drydock::device {

/// The one judgement of every DVL driver before it publishes: it drops a velocity or a distance
/// that no DVL can have, and keeps the rest of the sample.
inline void drop_impossible(measurement::BottomVelocity& sample, Output& out) {
  constexpr double most = fastest_in_water_mps;
  if (sample.velocity && !(sample.velocity->cwiseAbs().maxCoeff() <= most)) {
    sample.velocity.reset();
    sample.velocity_covariance.reset();
    sample.figure_of_merit_mps.reset();
    out.refuse("a velocity over the bed beyond 50 m/s was dropped: damaged on its way");
  }
  drop_outside(sample.error_velocity_mps, -most, most,
               "an error velocity beyond 50 m/s was dropped: damaged on its way", out);
  drop_impossible_range(sample.altitude_m, out);
  for (auto& range : sample.range_m) drop_impossible_range(range, out);
}

}  // namespace drydock::device
