#include "drivers/wire/described/notation.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>

#include "drivers/wire/text_fields.hpp"

namespace drydock::wire::described {
namespace {

using namespace std::chrono;

constexpr double day_s = 86400;

struct Named {
  std::string_view unit;
  Notation notation;
};
constexpr auto named = std::to_array<Named>({
    {"ddmm", {Digits::degrees_minutes}},
    {"hhmmss", {Digits::clock}},
    {"hh:mm:ss", {Digits::clock, ':'}},
    {"ddmmyy", {Digits::day_month_year}},
    {"ddmmyyyy", {Digits::day_month_year, 0, 4}},
    {"dd/mm/yy", {Digits::day_month_year, '/'}},
    {"dd/mm/yyyy", {Digits::day_month_year, '/', 4}},
    {"dd.mm.yyyy", {Digits::day_month_year, '.', 4}},
    {"dd-mm-yyyy", {Digits::day_month_year, '-', 4}},
    {"mmddyy", {Digits::month_day_year}},
    {"mm/dd/yy", {Digits::month_day_year, '/'}},
    {"mm/dd/yyyy", {Digits::month_day_year, '/', 4}},
    {"yymmdd", {Digits::year_month_day}},
    {"yyyymmdd", {Digits::year_month_day, 0, 4}},
    {"yyyy-mm-dd", {Digits::year_month_day, '-', 4}},
    {"yyyy/mm/dd", {Digits::year_month_day, '/', 4}},
});

std::optional<double> degrees_of(std::string_view text) {
  const auto number = parse_number(text);
  if (!number) return {};
  const double degrees = std::trunc(*number / 100), minutes = *number - 100 * degrees;
  if (std::abs(minutes) >= 60) return {};
  return degrees + minutes / 60;
}

/// Digits alone. Empty: another character, none, or more than eight.
std::optional<unsigned> whole(std::string_view text) {
  if (text.empty() || text.size() > 8) return {};
  unsigned value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return {};
    value = 10 * value + static_cast<unsigned>(c - '0');
  }
  return value;
}

/// The three parts of a time or date. Digits that stand together: the first part has what the
/// others leave, so 93519 is 9:35:19.
std::optional<std::array<std::string_view, 3>> parts(std::string_view text, char between,
                                                     std::size_t second, std::size_t third) {
  if (between == 0) {
    if (text.size() <= second + third) return {};
    const std::size_t first = text.size() - second - third;
    return std::array{text.substr(0, first), text.substr(first, second),
                      text.substr(first + second)};
  }
  const std::size_t a = text.find(between), b = a == text.npos ? a : text.find(between, a + 1);
  if (b == text.npos) return {};
  return std::array{text.substr(0, a), text.substr(a + 1, b - a - 1), text.substr(b + 1)};
}

std::optional<double> time_of_day(Notation notation, std::string_view text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  const auto [front, behind] = std::pair(text.substr(0, point), text.substr(point));
  const auto part = parts(front, notation.between, 2, 2);
  const auto fraction = behind.size() < 2 ? std::optional(0.0) : parse_number(behind);
  if (!part || !fraction) return {};
  const auto hour = whole((*part)[0]), minute = whole((*part)[1]), second = whole((*part)[2]);
  if (!hour || !minute || !second || *hour > 23 || *minute > 59 || *second > 60) return {};
  return *hour * 3600.0 + *minute * 60.0 + *second + *fraction;
}

std::optional<double> date_of(Notation notation, std::string_view text) {
  const bool year_first = notation.digits == Digits::year_month_day;
  const auto part = parts(text, notation.between, 2, year_first ? 2 : notation.year_digits);
  if (!part) return {};
  const auto a = whole((*part)[0]), b = whole((*part)[1]), c = whole((*part)[2]);
  if (!a || !b || !c) return {};
  const bool day_first = notation.digits == Digits::day_month_year;
  const unsigned named_year = year_first ? *a : *c;
  const unsigned month_number = year_first || day_first ? *b : *a;
  const unsigned day_number = year_first ? *c : day_first ? *a : *b;
  if (named_year > (notation.year_digits == 2 ? 99u : 9999u)) return {};
  const unsigned full =
      notation.year_digits == 4 ? named_year : named_year + (named_year < 80 ? 2000 : 1900);
  const year_month_day date{year{static_cast<int>(full)}, month{month_number}, day{day_number}};
  if (!date.ok() || full < 1970) return {};
  return static_cast<double>(sys_days{date}.time_since_epoch().count()) * day_s;
}

/// Writes decimal digits with zeros in front, and remembers whether they fitted.
class Text {
 public:
  Text(char* begin, char* end) : at_(begin), end_(end) {}
  void figure(double value, int width, unsigned decimals = 0) {
    std::array<char, 32> digits;
    const auto stop = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                    std::chars_format::fixed, static_cast<int>(decimals));
    if (stop.ec != std::errc{}) fits_ = false;
    const std::string_view text(digits.data(), stop.ptr);
    const auto whole_digits = static_cast<int>(std::min(text.find('.'), text.size()));
    for (int i = whole_digits; i < width; ++i) put('0');
    for (const char c : text) put(c);
  }
  void put(char c) {
    if (c == 0) return;
    if (at_ == end_)
      fits_ = false;
    else
      *at_++ = c;
  }
  std::size_t size(const char* begin) const {
    return fits_ ? static_cast<std::size_t>(at_ - begin) : 0;
  }

 private:
  char *at_, *end_;
  bool fits_ = true;
};

/// Sixtieths are rounded as a whole, so that 59.9996 becomes the next minute.
void write_degrees(double degrees, unsigned decimals, Text& text) {
  const double unit = std::pow(10, decimals), all = std::round(std::abs(degrees) * 60 * unit);
  const double whole_degrees = std::floor(all / (60 * unit));
  if (degrees < 0 && all > 0) text.put('-');
  text.figure(100 * whole_degrees + (all - whole_degrees * 60 * unit) / unit, 0, decimals);
}

void write_clock(Notation notation, double seconds, unsigned decimals, Text& text) {
  const double unit = std::pow(10, decimals);
  double left = std::fmod(std::round(seconds * unit), day_s * unit);
  if (left < 0) left += day_s * unit;
  for (const double part : {3600.0, 60.0}) {
    const double count = std::floor(left / (part * unit));
    text.figure(count, 2);
    text.put(notation.between);
    left -= count * part * unit;
  }
  text.figure(left / unit, 2, decimals);
}

void write_date(Notation notation, double seconds, Text& text) {
  const year_month_day date{sys_days{days{static_cast<int>(std::floor(seconds / day_s))}}};
  const int number = static_cast<int>(date.year());
  const double year_shown = notation.year_digits == 4 ? number : number % 100;
  const auto day_number = static_cast<unsigned>(date.day());
  const auto month_number = static_cast<unsigned>(date.month());
  const bool year_first = notation.digits == Digits::year_month_day;
  const bool day_first = notation.digits == Digits::day_month_year;
  text.figure(year_first  ? year_shown
              : day_first ? day_number
                          : month_number,
              year_first ? notation.year_digits : 2);
  text.put(notation.between);
  text.figure(year_first || day_first ? month_number : day_number, 2);
  text.put(notation.between);
  text.figure(year_first ? day_number : year_shown, year_first ? 2 : notation.year_digits);
}

}  // namespace

std::optional<Notation> notation_named(std::string_view unit) {
  for (const Named& one : named)
    if (one.unit == unit) return one.notation;
  return {};
}

std::optional<double> value_in(Notation notation, std::string_view text) {
  if (notation.digits == Digits::degrees_minutes) return degrees_of(text);
  return notation.is_date() ? date_of(notation, text) : time_of_day(notation, text);
}

std::size_t write_in(Notation notation, double value, unsigned decimals, char* begin, char* end) {
  Text text(begin, end);
  if (notation.digits == Digits::degrees_minutes)
    write_degrees(value, decimals, text);
  else if (notation.is_date())
    write_date(notation, value, text);
  else
    write_clock(notation, value, decimals, text);
  return text.size(begin);
}

}  // namespace drydock::wire::described
