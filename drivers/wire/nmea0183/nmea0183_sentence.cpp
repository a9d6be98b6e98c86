#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "drivers/wire/fields.hpp"
#include "drivers/wire/plain_number.hpp"
#include "drivers/wire/text_bytes.hpp"

namespace drydock::wire {
namespace {

/// Any number in decimal digits, without an exponent.
std::optional<double> decimal(std::string_view text) {
  text = trimmed(text);
  const bool negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  if (text.empty() || (!is_decimal_digit(text.front()) && text.front() != '.')) return std::nullopt;
  const char* const stop = text.data() + text.size();
  double magnitude = 0;
  const auto [end, error] = std::from_chars(text.data(), stop, magnitude, std::chars_format::fixed);
  if (error != std::errc{} || end != stop) return std::nullopt;
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

/// The number of two digits at the front of `text`.
int two_digits(std::string_view text) { return (text[0] - '0') * 10 + (text[1] - '0'); }

/// Nanoseconds of ".123", or of the point alone. It ignores digits after the ninth.
std::optional<std::int64_t> fraction_of_second(std::string_view text) {
  if (text.front() != '.') return std::nullopt;
  std::int64_t fraction_ns = 0, unit_ns = 100'000'000;
  for (const char c : text.substr(1)) {
    if (!is_decimal_digit(c)) return std::nullopt;
    fraction_ns += (c - '0') * unit_ns;
    unit_ns /= 10;
  }
  return fraction_ns;
}

}  // namespace

Bytes without_tag(Bytes frame) {
  if (frame.empty() || frame[0] != '\\') return frame;
  const auto end = std::find(frame.begin() + 1, frame.end(), std::uint8_t{'\\'});
  return end == frame.end() ? frame : Bytes(end + 1, frame.end());
}

SentenceReader::SentenceReader(Bytes frame) {
  frame = without_tag(frame);
  if (frame.empty() || frame[0] == '!') return;
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
  while (!ends_field(stop)) ++stop;
  pass(stop);
  return {start, static_cast<std::size_t>(stop - start)};
}

bool SentenceReader::fixed(char letter) {
  const std::string_view field = trimmed(text());
  return field.empty() ||
         (field.size() == 1 && (field[0] == letter || field[0] == (letter | 0x20)));
}

std::optional<double> SentenceReader::direction() {
  const auto degrees = number();
  if (!degrees || *degrees < 0 || *degrees > 360) return std::nullopt;
  return radians(*degrees);
}

Letter SentenceReader::letter() {
  const std::string_view field = trimmed(text());
  return field.size() == 1 ? Letter{field.front()} : Letter{};
}

bool SentenceReader::take_number(double& value) {
  if (skip_empty()) return false;
  const PlainNumber plain = plain_number(at_, end_);
  if (plain.is_exact() && ends_field(plain.end)) {
    value = plain.value();
    pass(plain.end);
    return true;
  }
  const auto slowly = decimal(text());
  value = slowly.value_or(0);
  return slowly.has_value();
}

bool SentenceReader::take_integer(int& value) {
  if (skip_empty()) return false;
  const PlainNumber plain = plain_number(at_, end_);
  if (plain.is_int() && ends_field(plain.end)) {
    value = static_cast<int>(plain.mantissa);
    pass(plain.end);
    return true;
  }
  const auto slowly = whole(text(), 10);
  value = slowly.value_or(0);
  return slowly.has_value();
}

std::optional<int> SentenceReader::hexadecimal() { return whole(text(), 16); }

std::optional<double> SentenceReader::eastward() {
  const auto magnitude = angle();
  const char side = letter().value;
  if (!magnitude || (side != 'E' && side != 'W')) return std::nullopt;
  return side == 'E' ? *magnitude : -*magnitude;
}

std::optional<double> SentenceReader::latitude() { return coordinate(90, 'N', 'S'); }

std::optional<double> SentenceReader::longitude() { return coordinate(180, 'E', 'W'); }

void SentenceReader::position(std::optional<double>& latitude_rad,
                              std::optional<double>& longitude_rad) {
  latitude_rad = latitude();
  longitude_rad = longitude();
  if (!latitude_rad || !longitude_rad) latitude_rad = longitude_rad = std::nullopt;
}

std::optional<double> SentenceReader::coordinate(double limit_deg, char positive, char negative) {
  const auto digits = number();
  const char hemisphere = letter().value;
  if (!digits || *digits < 0 || *digits > limit_deg * 100 ||
      (hemisphere != positive && hemisphere != negative)) {
    return std::nullopt;
  }
  const int whole_degrees = static_cast<int>(*digits / 100);
  const double minutes = *digits - whole_degrees * 100;
  const double angle = whole_degrees + minutes / 60;
  if (minutes >= 60) return std::nullopt;
  return radians(hemisphere == positive ? angle : -angle);
}

std::optional<std::chrono::nanoseconds> SentenceReader::time() {
  const std::string_view field = trimmed(text());
  if (field.size() < 6 || !std::all_of(field.begin(), field.begin() + 6, is_decimal_digit))
    return {};
  const int hour = two_digits(field), minute = two_digits(field.substr(2)),
            second = two_digits(field.substr(4));
  if (hour > 23 || minute > 59 || second > 60) return {};
  std::int64_t fraction_ns = 0;
  if (field.size() > 6) {
    const auto fraction = fraction_of_second(field.substr(6));
    if (!fraction) return {};
    fraction_ns = *fraction;
  }
  return std::chrono::hours{hour} + std::chrono::minutes{minute} + std::chrono::seconds{second} +
         std::chrono::nanoseconds{fraction_ns};
}

}  // namespace drydock::wire
