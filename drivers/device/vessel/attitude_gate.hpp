#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "drivers/device/driver.hpp"

/// What no compass of any vehicle says: every driver of the kind `attitude` refuses it.
namespace drydock::device {

/// Within one step of an angle on NMEA 2000, 1e-4 rad.
inline bool is_beyond(const std::optional<double>& value, double limit) {
  constexpr double rounding = 1e-4;
  return value && !(std::abs(*value) <= limit + rounding);
}

/// A heading of the sensor, from -180 or 0 to 360 degrees; its deviation and variation.
inline bool is_possible_heading(const std::optional<double>& heading_rad,
                                const std::optional<double>& deviation_rad,
                                const std::optional<double>& variation_rad, Output& out) {
  constexpr double half_turn = std::numbers::pi;
  const bool good = !is_beyond(heading_rad, 2 * half_turn) &&
                    !is_beyond(deviation_rad, half_turn) && !is_beyond(variation_rad, half_turn);
  if (!good) out.refuse("a heading beyond 360 degrees was dropped: damaged on its way");
  return good;
}

inline bool is_possible_turn(const std::optional<double>& rate_radps, Output& out) {
  constexpr double fastest_radps = 10;
  const bool good = !is_beyond(rate_radps, fastest_radps);
  if (!good) out.refuse("a rate of turn over 10 rad/s was dropped: damaged on its way");
  return good;
}

inline bool is_possible_tilt(const std::optional<double>& roll_rad,
                             const std::optional<double>& pitch_rad, Output& out) {
  constexpr double half_turn = std::numbers::pi;
  const bool good = !is_beyond(roll_rad, half_turn) && !is_beyond(pitch_rad, half_turn / 2);
  if (!good) out.refuse("a pitch beyond 90 or a roll beyond 180 degrees was dropped");
  return good;
}

}  // namespace drydock::device
