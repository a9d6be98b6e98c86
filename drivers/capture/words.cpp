#include "drivers/capture/words.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace drydock::capture {

namespace {

using std::chrono::nanoseconds;

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
using wire::fd_sizes;

constexpr std::int64_t power_of_ten(int exponent) {
  std::int64_t value = 1;
  while (exponent-- > 0) value *= 10;
  return value;
}

}  // namespace

std::string_view Words::peek() const {
  const auto begin = std::find_if_not(rest_.begin(), rest_.end(), is_blank);
  return {begin, std::find_if(begin, rest_.end(), is_blank)};
}

std::string_view Words::next() {
  const std::string_view word = peek();
  rest_ = word.empty() ? std::string_view{} : std::string_view{word.end(), rest_.end()};
  return word;
}

std::optional<nanoseconds> parse_time(std::string_view text, int exponent) {
  const std::size_t dot = std::min(text.find('.'), text.size());
  const std::string_view decimals = text.substr(std::min(dot + 1, text.size()));
  const std::int64_t unit = power_of_ten(exponent);
  std::int64_t whole = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + dot, whole);
  if (error != std::errc{} || end != text.data() + dot || whole < 0 ||
      whole >= latest_time.count() / unit) {
    return std::nullopt;
  }
  std::int64_t fraction = 0, worth = unit;
  for (const char digit : decimals) {
    if (digit < '0' || digit > '9') return std::nullopt;
    worth /= 10;  // ignores digits below one nanosecond
    fraction += (digit - '0') * worth;
  }
  return nanoseconds{whole * unit + fraction};
}

std::optional<nanoseconds> date_time(int year, unsigned month, unsigned day) {
  const std::chrono::year_month_day date{std::chrono::year{year}, std::chrono::month{month},
                                         std::chrono::day{day}};
  if (!date.ok() || year < 1970 || year > 2095) return std::nullopt;
  return std::chrono::sys_days{date}.time_since_epoch();
}

std::optional<nanoseconds> parse_clock(std::string_view text) {
  if (text.size() < 8 || text[2] != ':' || text[5] != ':') return std::nullopt;
  const auto hours = parse_number(text.substr(0, 2), 10);
  const auto minutes = parse_number(text.substr(3, 2), 10);
  const auto seconds = parse_time(text.substr(6), 9);
  if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 ||
      *seconds > std::chrono::seconds{61})
    return std::nullopt;
  return std::chrono::hours{*hours} + std::chrono::minutes{*minutes} + *seconds;
}

std::optional<nanoseconds> parse_date(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
  const auto year = parse_number(text.substr(0, 4), 10);
  const auto month = parse_number(text.substr(5, 2), 10);
  const auto day = parse_number(text.substr(8, 2), 10);
  if (!year || !month || !day) return std::nullopt;
  return date_time(static_cast<int>(*year), *month, *day);
}

std::optional<std::uint32_t> parse_number(std::string_view text, int base) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, base);
  if (text.empty() || error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

bool read_data(Words& words, std::size_t count, int base, wire::CanFrame& frame) {
  if (count > frame.data.size()) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view word = words.next();
    const auto byte = parse_number(word, base);
    if (!byte || *byte > 255 || (base == 16 && word.size() != 2)) return false;
    frame.data[i] = static_cast<std::uint8_t>(*byte);
  }
  frame.size = static_cast<std::uint8_t>(count);
  return true;
}

std::optional<std::uint8_t> size_of_length_code(std::uint32_t code) {
  if (code >= fd_sizes.size()) return std::nullopt;
  return fd_sizes[code];
}

wire::CanFrame unspecified_error() {
  constexpr std::uint32_t bus_error = 0x80;
  wire::CanFrame frame;
  frame.id = bus_error;
  frame.error = true;
  frame.size = 8;
  return frame;
}

}  // namespace drydock::capture
