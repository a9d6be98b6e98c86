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

/// `hh:mm:ss[.decimals]` at the front of the text, also `h:mm:ss PM`. Five numbers between colons
/// are none: an address, or a date in front of its time.
std::optional<Clock> clock_at(std::string_view text) {
  constexpr std::size_t behind_hours = 6;  // :mm:ss
  const std::size_t whole = digits_at(text) + behind_hours;
  if (whole < 7 || whole > 8 || text.size() < whole) return {};
  const std::size_t fraction = fraction_at(text.substr(whole));
  std::string figures(text.substr(0, whole + fraction));
  if (whole < 8) figures.insert(0, "0");
  std::ranges::replace(figures, ',', '.');
  const auto time = parse_clock(figures);
  std::string_view rest = text.substr(whole + fraction);
  if (!time || (rest.starts_with(':') && digits_at(rest.substr(1)) == 2)) return {};
  Clock clock{*time, whole + fraction, fraction == 0};
  const std::size_t blank = rest.starts_with(' ') ? 1 : 0;
  rest.remove_prefix(blank);
  if (rest.size() < 2 || (rest[1] | 0x20) != 'm') return clock;
  constexpr std::chrono::hours noon{12};
  const bool before = (rest[0] | 0x20) == 'a', after = (rest[0] | 0x20) == 'p';
  if (!before && !after) return clock;
  if (before && clock.since_midnight >= noon) clock.since_midnight -= noon;
  if (after && clock.since_midnight < noon) clock.since_midnight += noon;
  clock.size += blank + 2;
  return clock;
}

/// `+01:00`, `-0330` at the front of the text, or behind a blank.
nanoseconds offset_at(std::string_view text) {
  if (text.starts_with(' ')) text.remove_prefix(1);
  if (text.size() < 5 || (text[0] != '+' && text[0] != '-')) return {};
  const std::size_t minute = text[3] == ':' ? 4 : 3;
  if (text.size() < minute + 2) return {};
  const auto hours = parse_number(text.substr(1, 2), 10);
  const auto minutes = parse_number(text.substr(minute, 2), 10);
  if (!hours || !minutes || *hours > 14 || *minutes > 59) return {};
  const nanoseconds offset = std::chrono::hours{*hours} + std::chrono::minutes{*minutes};
  return text[0] == '-' ? -offset : offset;
}

/// The time of day that begins at `at`, with the date around it.
std::optional<LoggerTime> clock_with_date(std::string_view text, std::size_t at, DateOrder known) {
  const auto clock = clock_at(text.substr(at));
  if (!clock) return {};
  const auto behind = text.substr(at + clock->size);
  const auto date = date_before(text.substr(0, at), behind, known);
  if (!date) return LoggerTime{clock->since_midnight, true, clock->whole_second};
  return LoggerTime{date->midnight + clock->since_midnight - offset_at(behind), false,
                    clock->whole_second, date->order};
}

/// `20190326T100500[.decimals]`, also without a character between date and time.
std::optional<LoggerTime> compact_time(std::string_view text) {
  constexpr std::size_t date_size = 8, clock_size = 6;
  const auto date = compact_date(text.substr(0, date_size));
  if (!date) return {};
  text.remove_prefix(date_size);
  constexpr std::string_view between = "T_- ";
  if (!text.empty() && between.find(text[0]) != text.npos) text.remove_prefix(1);
  if (digits_at(text) != clock_size) return {};
  const std::size_t fraction = fraction_at(text.substr(clock_size));
  std::string figures(text.substr(0, clock_size + fraction));
  std::ranges::replace(figures, ',', '.');
  figures.insert(4, ":").insert(2, ":");
  const auto time = parse_clock(figures);
  if (!time) return {};
  return LoggerTime{*date + *time - offset_at(text.substr(clock_size + fraction)), false,
                    fraction == 0};
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

}  // namespace

std::optional<LoggerTime> logger_time(std::string_view text, DateOrder known) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!is_decimal(text[at]) || (at > 0 && is_decimal(text[at - 1]))) continue;
    if (const auto found = compact_time(text.substr(at))) return found;
    if (const auto found = clock_with_date(text, at, known)) return found;
    if (const auto found = since_1970(text.substr(at))) return found;
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
