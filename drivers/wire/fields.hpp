#pragma once

#include <array>
#include <chrono>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>

#include "drivers/measurement/units.hpp"

/// The fields of a message for printing. Each message has `type`, the protocol's name for it, and a
/// function `visit_fields(message, field)`. That function calls `field(key, value)` for every field
/// in order. Keys contain their unit (`latitude_deg`, `speed_mps`). A value is a scalar (integer,
/// double, bool, std::string_view), an optional of one, or a std::array or std::span of scalars, of
/// optionals, or of structs that also have visit_fields. An empty optional prints as null. Structs
/// hold SI units and radians; only the visit converts to degrees.
namespace drydock::wire {

template <class T>
concept ScalarField = std::is_arithmetic_v<T> || std::same_as<T, std::string_view>;

constexpr double zero_celsius_k = 273.15;

constexpr double radians(double degrees) { return degrees * units::degree; }

/// `value` rounded to a multiple of 1/`unit`.
constexpr double nearest(double value, double unit) {
  const double scaled = value * unit;
  return static_cast<double>(static_cast<std::int64_t>(scaled + (scaled < 0 ? -0.5 : 0.5))) / unit;
}

/// Converts to degrees. If a decimal of up to seven places gives exactly these radians, it returns
/// this decimal. Thus 3 degrees from a device print as 3, without the error of two conversions.
constexpr double degrees(double angle_rad) {
  const double nearly = angle_rad * units::degrees_per_radian;
  if (!(nearly > -1e8 && nearly < 1e8)) return nearly;
  if (const double whole = nearest(nearly, 1); radians(whole) == angle_rad) return whole;
  const double decimal = nearest(nearly, 1e7);
  return radians(decimal) == angle_rad ? decimal : nearly;
}

constexpr std::optional<double> degrees(const std::optional<double>& angle_rad) {
  return angle_rad ? std::optional{degrees(*angle_rad)} : std::nullopt;
}

constexpr std::optional<double> scaled(const std::optional<double>& value, double factor) {
  return value ? std::optional{*value * factor} : std::nullopt;
}

template <class Rep, class Period>
constexpr double seconds(std::chrono::duration<Rep, Period> duration) {
  return std::chrono::duration<double>(duration).count();
}

template <class Duration>
constexpr std::optional<double> seconds(const std::optional<Duration>& duration) {
  return duration ? std::optional{seconds(*duration)} : std::nullopt;
}

/// Dilution of precision. Receivers send 0, 99.9 or 99.99 if there is none.
constexpr std::optional<double> dilution(std::optional<double> sent) {
  return sent && *sent > 0 && *sent < 99.9 ? sent : std::nullopt;
}

/// Shows a calendar date as three integers.
template <class F>
void visit_date(const std::optional<std::chrono::year_month_day>& date, F&& field) {
  using Number = std::optional<int>;
  field("year", date ? Number{static_cast<int>(date->year())} : std::nullopt);
  field("month", date ? Number{static_cast<unsigned>(date->month())} : std::nullopt);
  field("day", date ? Number{static_cast<unsigned>(date->day())} : std::nullopt);
}

}  // namespace drydock::wire
