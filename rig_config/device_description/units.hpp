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
      {"d", d::time, 86400},
      {"week", d::time, 604800},
      {"hhmmss", d::time},
      {"hh:mm:ss", d::time},
      {"ddmmyy", d::date},
      {"ddmmyyyy", d::date},
      {"dd/mm/yy", d::date},
      {"dd/mm/yyyy", d::date},
      {"dd.mm.yyyy", d::date},
      {"dd-mm-yyyy", d::date},
      {"mmddyy", d::date},
      {"mm/dd/yy", d::date},
      {"mm/dd/yyyy", d::date},
      {"yymmdd", d::date},
      {"yyyymmdd", d::date},
      {"yyyy-mm-dd", d::date},
      {"yyyy/mm/dd", d::date},
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
      {"ddmm", d::angle, units::degree},
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

/// How DBC files write some units.
struct Spelling {
  std::string_view in_files, here;
};
inline constexpr auto spellings = std::to_array<Spelling>({{"m/s\u00b2", "m/s2"},
                                                           {"m/s^2", "m/s2"},
                                                           {"m/s/s", "m/s2"},
                                                           {"\u00b0", "deg"},
                                                           {"\u00b0/s", "deg/s"},
                                                           {"dps", "deg/s"},
                                                           {"\u00b0/h", "deg/h"},
                                                           {"\u00b0C", "degC"},
                                                           {"\u00b0F", "degF"}});

/// The unit of a DBC file, as a description writes it.
constexpr std::string_view as_described(std::string_view unit_of_file) {
  for (const Spelling& one : spellings)
    if (one.in_files == unit_of_file) return one.here;
  return unit_of_file;
}

}  // namespace drydock::rig_config
