#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/measurement/water_column.hpp"

/// What no vehicle in water does and no sensor of one says: a damaged value, or one of another
/// unit.
namespace drydock::device {

/// Torpedoes reach 40 m/s, DVLs and logs measure up to 20 m/s.
inline constexpr double fastest_in_water_mps = 50;

/// Removes what is not from `least` to `most`, NaN too, and tells it.
inline void drop_outside(std::optional<double>& value, double least, double most,
                         std::string_view why, Output& out) {
  if (!value || (*value >= least && *value <= most)) return;
  value.reset();
  out.refuse(why);
}

/// A vertical distance to the bed, of all beams or of one.
inline void drop_impossible_range(std::optional<double>& range_m, Output& out) {
  drop_outside(range_m, 0, measurement::deepest_sea_m,
               "a distance to the bed below zero or beyond 12 km was dropped: damaged on its way",
               out);
}

}  // namespace drydock::device
