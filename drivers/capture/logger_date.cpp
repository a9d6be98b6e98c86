#include "drivers/capture/logger_date.hpp"

#include <algorithm>
#include <array>

#include "drivers/capture/words.hpp"

namespace drydock::capture {
namespace {

using std::chrono::nanoseconds;

constexpr bool is_date_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_name_letter(char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; }
constexpr bool is_date_blank(char c) { return c == ' ' || c == '\t' || c == ','; }

/// A number or a name, and what stands between it and the one behind it.
struct Part {
  std::string_view text;
  char gap = 0;  ///< ' ' for blanks and commas
  bool is_number() const { return !text.empty() && is_date_digit(text[0]); }
  std::uint32_t number() const { return parse_number(text, 10).value_or(0); }
  bool is_short() const { return is_number() && text.size() <= 2; }
};

/// Takes the last part off the text.
Part last_part(std::string_view& text) {
  Part part;
  while (!text.empty() && is_date_blank(text.back())) {
    part.gap = ' ';
    text.remove_suffix(1);
  }
  if (part.gap == 0 && !text.empty() && std::string_view("-/.:+").find(text.back()) != text.npos) {
    part.gap = text.back();
    text.remove_suffix(1);
  }
  const bool digits = !text.empty() && is_date_digit(text.back());
  std::size_t size = 0;
  while (size < text.size() && (digits ? is_date_digit(text[text.size() - size - 1])
                                       : is_name_letter(text[text.size() - size - 1])))
    ++size;
  part.text = text.substr(text.size() - size);
  text.remove_suffix(size);
  return part;
}

/// 1 to 12; 0: no English name of a month.
unsigned month_of(std::string_view name) {
  constexpr std::array<std::string_view, 12> months{"jan", "feb", "mar", "apr", "may", "jun",
                                                    "jul", "aug", "sep", "oct", "nov", "dec"};
  if (name.size() < 3) return 0;
  const auto same = [](char a, char b) { return (a | 0x20) == b; };
  const auto found = std::ranges::find_if(months, [&](std::string_view month) {
    return std::ranges::equal(name.substr(0, 3), month, same);
  });
  return found == months.end() ? 0 : static_cast<unsigned>(found - months.begin()) + 1;
}

std::optional<LoggerDate> date_of(std::uint32_t year, unsigned month, unsigned day,
                                  DateOrder order = DateOrder::unknown) {
  const auto midnight = date_time(static_cast<int>(year), month, day);
  return midnight ? std::optional(LoggerDate{*midnight, order}) : std::nullopt;
}

std::optional<LoggerDate> day_of_year(std::uint32_t year, std::uint32_t day) {
  const auto first = date_time(static_cast<int>(year), 1, 1);
  const bool leap = std::chrono::year{static_cast<int>(year)}.is_leap();
  if (!first || day < 1 || day > (leap ? 366u : 365u)) return {};
  return LoggerDate{*first + std::chrono::days{day - 1}};
}

/// Two numbers and the year behind them.
std::optional<LoggerDate> year_last(unsigned first, unsigned second, std::uint32_t year, char gap,
                                    DateOrder known) {
  using enum DateOrder;
  constexpr unsigned months = 12;
  DateOrder shown = unknown;
  if (gap == '.' || first > months) shown = day_first;
  if (gap != '.' && second > months) shown = month_first;
  const DateOrder order = shown != unknown ? shown : known;
  if (order == unknown) return {};
  return order == day_first ? date_of(year, second, first, shown)
                            : date_of(year, first, second, shown);
}

/// ` 2019` at the front of the text.
std::uint32_t year_at(std::string_view text) {
  if (text.size() < 5 || text[0] != ' ' || !std::ranges::all_of(text.substr(1, 4), is_date_digit) ||
      (text.size() > 5 && is_date_digit(text[5])))
    return 0;
  return parse_number(text.substr(1, 4), 10).value_or(0);
}

}  // namespace

std::optional<nanoseconds> compact_date(std::string_view digits) {
  if (digits.size() != 8 || !std::ranges::all_of(digits, is_date_digit)) return {};
  return date_time(static_cast<int>(*parse_number(digits.substr(0, 4), 10)),
                   *parse_number(digits.substr(4, 2), 10), *parse_number(digits.substr(6), 10));
}

std::optional<LoggerDate> date_before(std::string_view text, std::string_view behind,
                                      DateOrder known) {
  if (text.size() > 1 && (text.back() == 'T' || text.back() == '_' || text.back() == 't') &&
      is_date_digit(text[text.size() - 2]))
    text.remove_suffix(1);
  const Part c = last_part(text), b = last_part(text), a = last_part(text);
  if (!c.is_number() || c.gap == '.') return {};
  if (const auto midnight = compact_date(c.text)) return LoggerDate{*midnight};
  constexpr std::string_view between_year_and_day = ":-/ ";
  if (c.text.size() == 3 && b.is_number()) {
    if (b.text.size() == 4 && between_year_and_day.find(b.gap) != text.npos)
      return day_of_year(b.number(), c.number());
    if (b.text.size() == 2 && b.gap == '+') return day_of_year(2000 + b.number(), c.number());
  }
  const unsigned month = b.is_short() ? b.number() : month_of(b.text);
  if (a.is_number() && a.text.size() == 4 && c.is_short())
    return date_of(a.number(), month, c.number());
  if (c.text.size() == 4) {
    if (a.is_short() && b.is_short() && a.gap == b.gap)
      return year_last(a.number(), b.number(), c.number(), a.gap, known);
    if (a.is_short()) return date_of(c.number(), month, a.number());
    if (b.is_short()) return date_of(c.number(), month_of(a.text), b.number());
  }
  if (c.is_short() && !b.is_number()) return date_of(year_at(behind), month, c.number());
  return {};
}

}  // namespace drydock::capture
