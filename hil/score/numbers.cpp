#include "hil/score/numbers.hpp"

#include <charconv>
#include <cmath>
#include <string>

namespace drydock::score {
namespace {

template <class Number>
std::optional<Number> whole_text(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

std::optional<double> number_of(std::string_view text) { return whole_text<double>(text); }
std::optional<std::int64_t> whole_number_of(std::string_view text) {
  return whole_text<std::int64_t>(text);
}

std::optional<measurement::Stamp> stamp_of_seconds(std::string_view text) {
  constexpr std::int64_t ns_per_s = 1'000'000'000, most_s = 9'000'000'000;
  const auto point = text.find('.');
  const auto whole = whole_number_of(text.substr(0, point));
  if (whole && std::abs(*whole) < most_s && *whole >= 0) {
    std::string digits{point == std::string_view::npos ? "" : text.substr(point + 1)};
    digits.resize(9, '0');
    const auto rest = whole_number_of(digits);
    if (rest && *rest >= 0) return measurement::stamp_from_ns(*whole * ns_per_s + *rest);
  }
  const auto seconds = number_of(text);  // 1.5e9
  if (!seconds || !(std::abs(*seconds) < static_cast<double>(most_s))) return {};
  return measurement::Stamp{measurement::from_seconds(*seconds)};
}

}  // namespace drydock::score
