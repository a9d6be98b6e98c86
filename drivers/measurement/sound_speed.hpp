#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

/// Speed of sound in sea water, m/s. Temperature in degrees Celsius, salinity in parts per thousand
/// (practical salinity), depth in metres.
namespace drydock::measurement {

/// K. V. Mackenzie, Nine-term equation for sound speed in the oceans, J. Acoust. Soc. Am. 70 (1981)
/// 807. Valid for 2 to 30 deg C, 25 to 40 ppt, 0 to 8000 m, within 0.07 m/s there.
constexpr double mackenzie_mps(double t, double salinity, double depth) {
  return 1448.96 + ((2.374e-4 * t - 5.304e-2) * t + 4.591) * t + 1.340 * (salinity - 35) +
         (1.675e-7 * depth + 1.630e-2) * depth - 1.025e-2 * t * (salinity - 35) -
         7.139e-13 * t * depth * depth * depth;
}

/// H. Medwin, Speed of sound in water: a simple equation for realistic parameters, J. Acoust. Soc.
/// Am. 58 (1975) 1318. Valid for 0 to 35 deg C, 0 to 45 ppt, 0 to 1000 m: also for fresh water.
constexpr double medwin_mps(double t, double salinity, double depth) {
  return 1449.2 + ((0.00029 * t - 0.055) * t + 4.6) * t + (1.34 - 0.010 * t) * (salinity - 35) +
         0.016 * depth;
}

enum class SoundSpeedEquation : std::uint8_t { mackenzie, medwin };

inline constexpr std::array<std::string_view, 2> sound_speed_equations{"mackenzie", "medwin"};

constexpr double sound_speed_mps(SoundSpeedEquation by, double t, double salinity, double depth) {
  return by == SoundSpeedEquation::mackenzie ? mackenzie_mps(t, salinity, depth)
                                             : medwin_mps(t, salinity, depth);
}

inline constexpr double melting_point_k = 273.15;
/// Where nobody tells it: that of the ocean, and what most DVLs are set to.
inline constexpr double usual_salinity_ppt = 35;

}  // namespace drydock::measurement
