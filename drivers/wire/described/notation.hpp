#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

/// Numbers of a text that no factor turns into SI: degrees with minutes, times of day, dates.
namespace drydock::wire::described {

enum class Digits : std::uint8_t {
  plain,
  degrees_minutes,  ///< 5430.5 is 54 degrees and 30.5 minutes
  clock,            ///< 123519.25 is 12:35:19.25; its value is in seconds since midnight
  day_month_year,   ///< a date's value is in seconds since 1970
  month_day_year,
  year_month_day
};

struct Notation {
  Digits digits = Digits::plain;
  char between = 0;              ///< "12:35:19", "2026-11-26"; 0: the digits stand together
  std::uint8_t year_digits = 2;  ///< of two: 80 to 99 are of the last century

  bool is_plain() const { return digits == Digits::plain; }
  bool is_date() const { return digits >= Digits::day_month_year; }
  friend bool operator==(const Notation&, const Notation&) = default;
};

/// What `hhmmss`, `dd/mm/yyyy` and their like mean as a unit. Empty: it is none of them.
std::optional<Notation> notation_named(std::string_view unit);

/// The value of a text. Empty: it has another form, or there is no such minute, time or date.
std::optional<double> value_in(Notation notation, std::string_view text);

/// The text of a value, with so many decimals: of degrees and minutes, those of the minute. 60
/// minutes or seconds are never written. Returns the characters written; 0: they do not fit.
std::size_t write_in(Notation notation, double value, unsigned decimals, char* begin, char* end);

}  // namespace drydock::wire::described
