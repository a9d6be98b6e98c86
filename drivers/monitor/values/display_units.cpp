#include "drivers/monitor/values/display_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "drivers/measurement/sound_speed.hpp"
#include "drivers/measurement/units.hpp"

namespace drydock::monitor {
namespace {

constexpr double foot = 0.3048;

/// The first of an ending is the usual one. An ending comes before those that it ends with.
constexpr std::array display_units{
    DisplayUnit{"m/s2", "_mps2", 1, 0, 5},
    DisplayUnit{"deg/s", "_degps", 1, 0, 4},
    DisplayUnit{"r/min", "_radps", 1 / units::revolution_per_minute, 0, 2},
    DisplayUnit{"rad/s", "_radps", 1, 0, 3},
    DisplayUnit{"dBHz", "_dbhz", 1, 0, 1},
    DisplayUnit{"ppt", "_ppt", 1, 0, 1},
    DisplayUnit{"m/s", "_mps", 1, 0, 3},
    DisplayUnit{"kn", "_mps", 1 / units::knot, 0, 3},
    DisplayUnit{"km/h", "_mps", 1 / units::kilometre_per_hour, 0, 2},
    DisplayUnit{"deg", "_deg", 1, 0, 3},
    DisplayUnit{"rad", "_deg", units::degree, 0, 5},
    DisplayUnit{"kPa", "_pa", 1e-3, 0, 3},
    DisplayUnit{"Pa", "_pa", 1, 0, 0},
    DisplayUnit{"hPa", "_pa", 1e-2, 0, 2},
    DisplayUnit{"bar", "_pa", 1e-5, 0, 5},
    DisplayUnit{"dbar", "_pa", 1e-4, 0, 4},
    DisplayUnit{"°C", "_k", 1, -measurement::melting_point_k, 3},
    DisplayUnit{"K", "_k", 1, 0, 3},
    DisplayUnit{"m", "_m", 1, 0, 3},
    DisplayUnit{"ft", "_m", 1 / foot, 0, 2},
    DisplayUnit{"s", "_s", 1, 0, 3},
};

constexpr double newest_s = 2;  // a value this much older than its device's newest shows its age

/// The speed of sound is no vehicle's: nobody reads it in knots.
bool is_of_the_water(std::string_view field) { return field == "sound_speed_mps"; }

bool is_place(std::string_view field) {
  return field == "latitude_deg" || field == "longitude_deg";
}

std::string in_figures(double number, int decimals) {
  return std::isfinite(number) ? fmt::format("{:.{}f}", number, decimals) : std::string("-");
}

}  // namespace

std::string ShownValue::full() const {
  std::string all = text;
  if (!unit.empty()) all += ' ' + unit;
  if (older_s > newest_s) all += fmt::format(" ({:.0f} s ago)", older_s);
  return all;
}

std::string DisplayUnits::allowed() {
  std::string all;
  for (const auto& unit : display_units) all += (all.empty() ? "" : ", ") + std::string(unit.name);
  return all;
}

DisplayUnits DisplayUnits::of(std::string_view names) {
  DisplayUnits units;
  while (!names.empty()) {
    const auto comma = std::min(names.find(','), names.size());
    const auto name = names.substr(0, comma);
    const auto found = std::ranges::find(display_units, name, &DisplayUnit::name);
    if (found == display_units.end())
      throw std::invalid_argument(fmt::format("\"{}\" is no unit; allowed: {}", name, allowed()));
    units.chosen_.push_back(&*found);
    names.remove_prefix(std::min(comma + 1, names.size()));
  }
  return units;
}

const DisplayUnit* DisplayUnits::unit_of(std::string_view field) const {
  const auto of_field = [&](const DisplayUnit& unit) { return field.ends_with(unit.ending); };
  const auto usual = std::ranges::find_if(display_units, of_field);
  if (usual == display_units.end()) return nullptr;
  if (is_of_the_water(field)) return &*usual;
  for (const auto* unit : chosen_)
    if (unit->ending == usual->ending) return unit;
  return &*usual;
}

ShownValue DisplayUnits::shown(std::string_view field, std::span<const double> numbers) const {
  ShownValue value;
  const auto* unit = unit_of(field);
  value.name = field.substr(0, field.size() - (unit ? unit->ending.size() : 0));
  if (unit) value.unit = unit->name;
  if (field == "utc_s" && !numbers.empty()) {
    value.text = clock_text(numbers[0], 2);
    value.unit = "UTC";
    return value;
  }
  const int decimals = is_place(field) && unit->factor == 1 ? 7 : unit ? unit->decimals : 3;
  for (const double number : numbers) {
    value.numbers.push_back(unit ? number * unit->factor + unit->offset : number);
    const bool whole = !unit && number == std::floor(number);
    value.text +=
        (value.text.empty() ? "" : " ") + in_figures(value.numbers.back(), whole ? 0 : decimals);
  }
  return value;
}

std::string clock_text(double utc_s, int decimals) {
  constexpr double day_s = 86'400;
  const double scale = std::pow(10, decimals);
  const double of_day = std::fmod(std::floor(utc_s * scale + 0.5) / scale, day_s);
  const auto whole = static_cast<int>(of_day);
  std::string text = fmt::format("{:02}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  if (decimals > 0)
    text += fmt::format("{:.{}f}", std::max(0.0, of_day - whole), decimals).substr(1);
  return text;
}

std::string device_clock_text(double device_time_s) {
  constexpr double year_2001_s = 1e9;  // a clock since boot or since the week's begin shows less
  if (device_time_s < year_2001_s) return fmt::format("{:.3f} s", device_time_s);
  return clock_text(device_time_s);
}

}  // namespace drydock::monitor
