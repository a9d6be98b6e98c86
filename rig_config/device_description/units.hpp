#pragma once

#include <array>
#include <string_view>

#include "drivers/measurement/units.hpp"
#include "drivers/wire/described/targets.hpp"

namespace drydock::rig_config {

/// A unit of the wire: SI value = figure * factor + offset.
struct WireUnit {
  std::string_view name;
  wire::described::Dimension dimension;
  double factor = 1, offset = 0;
};

/// 5430.5 is 54 degrees and 30.5 minutes: no factor tells it.
inline constexpr std::string_view degrees_and_minutes = "ddmm";

/// The units that a description can name. Pressures: NIST SP 811 (2008) and ISO 80000-4. psi: lbf
/// of standard gravity over a square inch; mH2O and inHg: conventional, with 1000 and 13595.1
/// kg/m3.
inline constexpr auto wire_units = [] {
  namespace d = wire::described::dimension;
  constexpr double g = units::standard_gravity, inch = 0.0254, foot = 12 * inch;
  constexpr double psi = 0.45359237 * g / (inch * inch), mercury = 13595.1 * g;
  constexpr double fahrenheit = 5.0 / 9, zero_celsius = 273.15;
  return std::to_array<WireUnit>({
      {"1", d::none},
      {"m", d::length},
      {"dm", d::length, 0.1},
      {"cm", d::length, 0.01},
      {"mm", d::length, 1e-3},
      {"km", d::length, 1e3},
      {"ft", d::length, foot},
      {"fathom", d::length, 6 * foot},
      {"nmi", d::length, units::nautical_mile},
      {"s", d::time},
      {"ms", d::time, 1e-3},
      {"us", d::time, 1e-6},
      {"ns", d::time, 1e-9},
      {"min", d::time, 60},
      {"h", d::time, 3600},
      {"m/s", d::speed},
      {"cm/s", d::speed, 0.01},
      {"mm/s", d::speed, 1e-3},
      {"km/h", d::speed, units::kilometre_per_hour},
      {"kn", d::speed, units::knot},
      {"ft/s", d::speed, foot},
      {"m2/s2", d::variance},
      {"m/s2", d::acceleration},
      {"g", d::acceleration, g},
      {"mg", d::acceleration, units::milli_g},
      {"ug", d::acceleration, units::micro_g},
      {"Pa", d::pressure},
      {"hPa", d::pressure, 1e2},
      {"kPa", d::pressure, 1e3},
      {"MPa", d::pressure, 1e6},
      {"mbar", d::pressure, 1e2},
      {"dbar", d::pressure, 1e4},
      {"bar", d::pressure, 1e5},
      {"psi", d::pressure, psi},
      {"inHg", d::pressure, inch * mercury},
      {"mmHg", d::pressure, 1e-3 * mercury},
      {"mH2O", d::pressure, 1000 * g},
      {"rad", d::angle},
      {"mrad", d::angle, 1e-3},
      {"deg", d::angle, units::degree},
      {"arcmin", d::angle, units::degree / 60},
      {degrees_and_minutes, d::angle, units::degree},
      {"rad/s", d::turn_rate},
      {"mrad/s", d::turn_rate, 1e-3},
      {"deg/s", d::turn_rate, units::degree},
      {"deg/h", d::turn_rate, units::degree_per_hour},
      {"rpm", d::turn_rate, units::revolution_per_minute},
      {"K", d::temperature},
      {"degC", d::temperature, 1, zero_celsius},
      {"degF", d::temperature, fahrenheit, zero_celsius - 32 * fahrenheit},
  });
}();

constexpr const WireUnit* find_unit(std::string_view name) {
  for (const WireUnit& unit : wire_units)
    if (unit.name == name) return &unit;
  return nullptr;
}

}  // namespace drydock::rig_config
