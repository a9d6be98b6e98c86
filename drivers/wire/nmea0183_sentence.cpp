#include "drivers/wire/nmea0183_sentence.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "drivers/wire/fields.hpp"

namespace drydock::wire {
namespace {

constexpr std::array<double, 16> powers_of_ten{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

double parsed_slowly(std::string_view digits) {
  double value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  return value;
}

/// Up to 15 digits a quotient of two exact doubles is the correctly rounded value.
std::optional<double> decimal(std::string_view text) {
  text = trimmed(text);
  const bool negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  std::uint64_t mantissa = 0;
  std::size_t digits = 0, fraction = 0;
  bool point = false;
  for (const char c : text) {
    if (c == '.' && !point) {
      point = true;
    } else if (is_digit(c)) {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
      ++digits;
      fraction += point;
    } else {
      return std::nullopt;
    }
  }
  if (digits == 0) return std::nullopt;
  const double magnitude = digits < powers_of_ten.size()
                               ? static_cast<double>(mantissa) / powers_of_ten[fraction]
                               : parsed_slowly(text);
  return negative ? -magnitude : magnitude;
}

std::optional<int> whole(std::string_view text, int base) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Number of two digits at the front of `text`.
int two_digits(std::string_view text) { return (text[0] - '0') * 10 + (text[1] - '0'); }

}  // namespace

SentenceReader::SentenceReader(Bytes frame) {
  if (frame.empty()) return;
  const auto* begin = reinterpret_cast<const char*>(frame.data()) + 1;
  const auto* star = static_cast<const char*>(std::memchr(begin, '*', frame.size() - 1));
  end_ = star ? star : begin + frame.size() - 1;
  at_ = begin;
  const std::string_view address = text();
  if (address.size() != 5 || address.front() == 'P') return;
  talker_ = Talker{address};
  formatter_ = address.substr(2);
}

std::size_t SentenceReader::remaining() const {
  return at_ ? static_cast<std::size_t>(std::count(at_, end_, ',')) + 1 : 0;
}

std::string_view SentenceReader::text() {
  if (!at_) return {};
  const char* const start = at_;
  const char* stop = start;
  while (stop != end_ && *stop != ',') ++stop;
  at_ = stop == end_ ? nullptr : stop + 1;
  return {start, static_cast<std::size_t>(stop - start)};
}

void SentenceReader::skip(std::size_t fields) {
  while (fields-- > 0) text();
}

Letter SentenceReader::letter() {
  const std::string_view field = trimmed(text());
  return field.size() == 1 ? Letter{field.front()} : Letter{};
}

std::optional<double> SentenceReader::number() { return decimal(text()); }

std::optional<int> SentenceReader::integer() { return whole(text(), 10); }

std::optional<int> SentenceReader::hexadecimal() { return whole(text(), 16); }

std::optional<double> SentenceReader::angle() {
  const auto value = number();
  return value ? std::optional{radians(*value)} : std::nullopt;
}

std::optional<double> SentenceReader::latitude() { return coordinate(90, 'N', 'S'); }

std::optional<double> SentenceReader::longitude() { return coordinate(180, 'E', 'W'); }

std::optional<double> SentenceReader::coordinate(double limit_deg, char positive, char negative) {
  const auto digits = number();
  const char hemisphere = letter().value;
  if (!digits || *digits < 0 || (hemisphere != positive && hemisphere != negative)) {
    return std::nullopt;
  }
  const double whole_degrees = std::floor(*digits / 100);
  const double minutes = *digits - whole_degrees * 100;
  const double angle = whole_degrees + minutes / 60;
  if (minutes >= 60 || angle > limit_deg) return std::nullopt;
  return radians(hemisphere == positive ? angle : -angle);
}

std::optional<std::chrono::nanoseconds> SentenceReader::time() {
  const std::string_view field = trimmed(text());
  if (field.size() < 6 || !std::all_of(field.begin(), field.begin() + 6, is_digit)) return {};
  const int hour = two_digits(field), minute = two_digits(field.substr(2)),
            second = two_digits(field.substr(4));
  if (hour > 23 || minute > 59 || second > 60) return {};
  std::int64_t fraction_ns = 0;
  if (field.size() > 6) {
    const auto fraction = decimal(field.substr(6));
    if (field[6] != '.' || (!fraction && field.size() > 7)) return {};
    fraction_ns = std::min(std::llround(fraction.value_or(0) * 1e9), 999'999'999LL);
  }
  return std::chrono::hours{hour} + std::chrono::minutes{minute} + std::chrono::seconds{second} +
         std::chrono::nanoseconds{fraction_ns};
}

}  // namespace drydock::wire
