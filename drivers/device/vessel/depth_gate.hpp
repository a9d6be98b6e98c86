#pragma once

#include "drivers/device/driver.hpp"
#include "drivers/measurement/water_column.hpp"

namespace drydock::device {

/// The one judgement of every depth driver before it publishes: false for a sample that cannot be
/// true in any sea. It is refused, and so counted in the health of the device.
inline bool is_possible(const measurement::DepthSample& sample, Output& out) {
  if (sample.pressure_pa && !measurement::is_sea_pressure(*sample.pressure_pa)) {
    out.refuse("a pressure below zero or over 1200 bar was refused: damaged, or in another unit");
    return false;
  }
  if (sample.depth_m && !measurement::is_sea_depth(*sample.depth_m)) {
    out.refuse("a depth over 12 km, or 100 m above the surface, was refused: damaged on its way");
    return false;
  }
  if (sample.altitude_m &&
      !(*sample.altitude_m >= 0 && *sample.altitude_m <= measurement::deepest_sea_m)) {
    out.refuse("a height over the bed below zero or beyond 12 km was refused: damaged on its way");
    return false;
  }
  return true;
}

}  // namespace drydock::device
