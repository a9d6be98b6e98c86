#include "hil/score/numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "drivers/text/utc.hpp"

namespace drydock::score {
namespace {

template <class Number>
std::optional<Number> whole_text(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

/// The number is 0.DIGITS times ten to the power of `point`.
struct Decimal {
  bool negative = false;
  std::string digits;  ///< does not begin with 0
  std::int64_t point = 0;
};

std::optional<std::int64_t> exponent_of(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto read = whole_text<std::int64_t>(text);
  constexpr std::int64_t most = 100'000;  // more than any digits make up for
  return read && *read >= -most && *read <= most ? read : std::nullopt;
}

std::optional<Decimal> decimal_of(std::string_view text) {
  Decimal decimal;
  decimal.negative = text.starts_with('-');
  if (decimal.negative) text.remove_prefix(1);
  const auto e = text.find_first_of("eE");
  const auto exponent = e == std::string_view::npos ? 0 : exponent_of(text.substr(e + 1));
  const std::string_view mantissa = text.substr(0, e);
  const auto dot = std::min(mantissa.find('.'), mantissa.size());
  decimal.digits = mantissa.substr(0, dot);
  if (dot < mantissa.size()) decimal.digits += mantissa.substr(dot + 1);
  const bool all_digits =
      std::ranges::all_of(decimal.digits, [](char c) { return c >= '0' && c <= '9'; });
  if (!exponent || decimal.digits.empty() || !all_digits) return {};
  const auto zeros = std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size());
  decimal.digits.erase(0, zeros);
  decimal.point = static_cast<std::int64_t>(dot) - static_cast<std::int64_t>(zeros) + *exponent;
  return decimal;
}

bool is_whole(const Decimal& decimal) {
  const auto last = decimal.digits.find_last_not_of('0');
  return last == std::string::npos || static_cast<std::int64_t>(last) < decimal.point;
}

/// Rounded to the nearest whole number; empty if it does not fit.
std::optional<std::int64_t> rounded(const Decimal& decimal) {
  constexpr std::int64_t most_digits = 18;
  if (decimal.digits.empty() || decimal.point < 0) return 0;
  if (decimal.point > most_digits + 1) return {};
  std::string whole = decimal.digits;
  whole.resize(static_cast<std::size_t>(decimal.point) + 1, '0');
  const bool up = whole.back() >= '5';
  whole.back() = decimal.negative ? '-' : '0';
  std::rotate(whole.begin(), whole.end() - 1, whole.end());
  const auto value = whole_text<std::int64_t>(whole == "-" ? "0" : whole);
  constexpr std::int64_t limit = 9'000'000'000'000'000'000;
  if (!value || *value > limit || *value < -limit) return {};
  return *value + (up ? decimal.negative ? -1 : 1 : 0);
}

std::optional<measurement::Stamp> stamp_of(const std::optional<std::int64_t>& ns) {
  return ns ? std::optional(measurement::stamp_from_ns(*ns)) : std::nullopt;
}

}  // namespace

std::optional<double> number_of(std::string_view text) { return whole_text<double>(text); }

std::optional<measurement::Stamp> stamp_of_decimal(std::string_view text, int digits) {
  auto decimal = decimal_of(text);
  if (!decimal) return {};
  decimal->point += digits;
  return stamp_of(rounded(*decimal));
}

std::optional<measurement::Stamp> stamp_of_seconds(std::string_view text) {
  return stamp_of_decimal(text, 9);
}

std::optional<measurement::Stamp> stamp_of_any(std::string_view text) {
  if (text.find(':') != std::string_view::npos) {
    std::string utc(text);
    if (utc.size() > 10 && utc[10] == ' ') utc[10] = 'T';
    if (utc.ends_with("+00:00")) utc.resize(utc.size() - 6);
    return text::parse_utc(utc.ends_with('Z') ? utc : utc + 'Z');
  }
  const auto number = number_of(text);
  if (!number) return {};
  const double size = std::abs(*number);
  return stamp_of_decimal(text, size < 1e11 ? 9 : size < 1e14 ? 6 : size < 1e17 ? 3 : 0);
}

std::optional<measurement::Stamp> stamp_of_nanoseconds(std::string_view text) {
  const auto decimal = decimal_of(text);
  if (!decimal || !is_whole(*decimal)) return {};
  return stamp_of(rounded(*decimal));
}

}  // namespace drydock::score
