#pragma once

#include <numbers>

#include "drivers/device/vehicle_limits.hpp"

namespace drydock::device {

/// The one judgement of every GNSS driver before it publishes a fix: it drops what no receiver of
/// a vehicle says, and keeps the rest. Receivers are made to stop at 515 m/s and 50 or 80 km.
inline void drop_impossible(measurement::GnssFix& fix, Output& out) {
  constexpr double fastest_mps = 1000, highest_m = 100e3, half_turn = std::numbers::pi;
  if (fix.position && !(std::abs(fix.position->latitude_rad) <= half_turn / 2 &&
                        std::abs(fix.position->longitude_rad) <= half_turn)) {
    fix.position.reset();
    out.refuse("a position that is not on the Earth was dropped: damaged on its way");
  }
  for (auto* height : {&fix.ellipsoidal_height_m, &fix.mean_sea_level_height_m})
    drop_outside(*height, -highest_m, highest_m,
                 "a height beyond 100 km was dropped: damaged on its way", out);
  if (fix.velocity_ned && !(fix.velocity_ned->cwiseAbs().maxCoeff() <= fastest_mps)) {
    fix.velocity_ned.reset();
    out.refuse("a velocity beyond 1000 m/s was dropped: damaged on its way");
  }
  drop_outside(fix.ground_speed_mps, 0, fastest_mps,
               "a ground speed below zero or over 1000 m/s was dropped: damaged on its way", out);
}

inline void publish_possible(measurement::GnssFix fix, Output& out) {
  drop_impossible(fix, out);
  out.publish(fix);
}

}  // namespace drydock::device
