#include "drivers/terminal/duration.hpp"

#include <fmt/format.h>

#include <charconv>

namespace drydock::terminal {
namespace {

constexpr double longest_s = 100 * 365.25 * 86400;  // a Stamp counts nanoseconds and ends in the
                                                    // year 2262

std::optional<double> within_a_century(double seconds) {
  if (!(seconds >= 0 && seconds <= longest_s)) return std::nullopt;
  return seconds;
}

}  // namespace

std::optional<double> parse_duration(std::string_view text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  const std::string_view unit(rest, static_cast<std::size_t>(text.data() + text.size() - rest));
  if (unit.empty() || unit == "s") return within_a_century(value);
  if (unit == "min") return within_a_century(value * 60);
  if (unit == "h") return within_a_century(value * 3600);
  if (unit == "d") return within_a_century(value * 86400);
  return std::nullopt;
}

std::string no_duration(std::string_view text) {
  return fmt::format("'{}' is no duration; allowed: 90, 60s, 10min, 5.5h", text);
}

}  // namespace drydock::terminal
