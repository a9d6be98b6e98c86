#include "drivers/capture/logger_time.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "drivers/capture/words.hpp"

namespace drydock::capture {
namespace {

using std::chrono::nanoseconds;

constexpr bool is_decimal(char c) { return c >= '0' && c <= '9'; }

std::size_t digits_at(std::string_view text) {
  const auto end = std::ranges::find_if_not(text, is_decimal);
  return static_cast<std::size_t>(end - text.begin());
}

/// Digits of a fraction behind a point or a comma, the mark included.
std::size_t fraction_at(std::string_view text) {
  if (text.empty() || (text[0] != '.' && text[0] != ',')) return 0;
  const std::size_t digits = digits_at(text.substr(1));
  return digits > 0 ? 1 + digits : 0;
}

struct Clock {
  nanoseconds since_midnight{};
  std::size_t size = 0;  ///< characters
  bool whole_second = false;
};

/// `hh:mm:ss[.decimals]` at the front of the text.
std::optional<Clock> clock_at(std::string_view text) {
  constexpr std::size_t whole = 8;
  if (text.size() < whole) return {};
  const std::size_t fraction = fraction_at(text.substr(whole));
  std::string figures(text.substr(0, whole + fraction));
  std::ranges::replace(figures, ',', '.');
  const auto time = parse_clock(figures);
  if (!time) return {};
  return Clock{*time, whole + fraction, fraction == 0};
}

/// `+01:00`, `-0330` at the front of the text.
nanoseconds offset_at(std::string_view text) {
  if (text.size() < 5 || (text[0] != '+' && text[0] != '-')) return {};
  const std::size_t minute = text[3] == ':' ? 4 : 3;
  if (text.size() < minute + 2) return {};
  const auto hours = parse_number(text.substr(1, 2), 10);
  const auto minutes = parse_number(text.substr(minute, 2), 10);
  if (!hours || !minutes || *hours > 14 || *minutes > 59) return {};
  const nanoseconds offset = std::chrono::hours{*hours} + std::chrono::minutes{*minutes};
  return text[0] == '-' ? -offset : offset;
}

/// A date, one character or several blanks, and a time of day.
std::optional<LoggerTime> date_and_clock(std::string_view text) {
  constexpr std::size_t date_size = 10;
  if (text.size() < date_size + 9) return {};
  std::string date(text.substr(0, date_size));
  std::ranges::replace(date, '/', '-');
  const auto day = parse_date(date);
  if (!day) return {};
  std::string_view rest = text.substr(date_size + 1);
  while (!rest.empty() && rest[0] == ' ') rest.remove_prefix(1);
  const auto clock = clock_at(rest);
  if (!clock) return {};
  return LoggerTime{*day + clock->since_midnight - offset_at(rest.substr(clock->size)), false,
                    clock->whole_second};
}

/// Ten digits are seconds since 2001, thirteen milliseconds, and so on.
std::optional<LoggerTime> since_1970(std::string_view text) {
  const std::size_t digits = digits_at(text);
  if (digits != 10 && digits != 13 && digits != 16 && digits != 19) return {};
  const std::size_t fraction = fraction_at(text.substr(digits));
  std::string figures(text.substr(0, digits + fraction));
  std::ranges::replace(figures, ',', '.');
  const auto time = parse_time(figures, 9 - static_cast<int>(digits - 10));
  if (!time || *time < std::chrono::seconds{1'000'000'000}) return {};
  return LoggerTime{*time, false, digits == 10 && fraction == 0};
}

std::optional<LoggerTime> time_at(std::string_view text) {
  if (auto found = date_and_clock(text)) return found;
  if (const auto clock = clock_at(text))
    return LoggerTime{clock->since_midnight, true, clock->whole_second};
  return since_1970(text);
}

}  // namespace

std::optional<LoggerTime> logger_time(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!is_decimal(text[at]) || (at > 0 && is_decimal(text[at - 1]))) continue;
    if (const auto found = time_at(text.substr(at))) return found;
  }
  return {};
}

std::optional<LoggerTime> tag_block_time(std::string_view text) {
  for (const std::string_view key : {"\\c:", ",c:"})
    if (const auto at = text.find(key); at != text.npos)
      return since_1970(text.substr(at + key.size()));
  return {};
}

}  // namespace drydock::capture
