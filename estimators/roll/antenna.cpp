#include "estimators/roll/antenna.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::roll {

Power power_of(const AntennaOptions& antenna, const SightLine& line, double roll_rad) {
  constexpr double least_sine = 1e-6;  // avoids 0 / 0 on the boresight and opposite to it
  const double off = std::acos(std::clamp(line.sin_elevation(roll_rad), -1.0, 1.0));
  const double width_squared = antenna.width_rad * antenna.width_rad;
  const double value = std::exp(-off * off / width_squared);
  const double off_by_sine = std::max(off, least_sine) / std::max(std::sin(off), least_sine);
  return {value, 2 * value * off_by_sine / width_squared * line.slope(roll_rad)};
}

}  // namespace drydock::roll
