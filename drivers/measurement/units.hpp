#pragma once

#include <numbers>

/// Units as factors: a figure times its unit is the value in SI units and radians.
namespace drydock::units {

inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double degrees_per_radian = 180 / std::numbers::pi;
inline constexpr double degree_per_hour = degree / 3600;
inline constexpr double revolution_per_minute = 2 * std::numbers::pi / 60;

inline constexpr double standard_gravity = 9.80665;  ///< m/s2, ISO 80000-3
inline constexpr double milli_g = 1e-3 * standard_gravity, micro_g = 1e-6 * standard_gravity;

inline constexpr double nautical_mile = 1852.0;
inline constexpr double knot = nautical_mile / 3600.0;
inline constexpr double kilometre_per_hour = 1.0 / 3.6;

}  // namespace drydock::units
