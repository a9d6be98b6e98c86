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

SentenceWriter::SentenceWriter(std::span<std::uint8_t> out, Talker talker,
                               std::string_view formatter)
    : out_(out) {
  put('$');
  put(talker.text());
  put(formatter);
}

void SentenceWriter::text(std::string_view text) {
  put(',');
  put(text);
}

void SentenceWriter::letter(Letter letter) { text(letter.text().value_or(std::string_view{})); }

void SentenceWriter::number(const std::optional<double>& value, int decimals) {
  put(',');
  if (!value || !std::isfinite(*value)) return;
  std::array<char, 40> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), *value,
                                          std::chars_format::fixed, decimals);
  if (error != std::errc{}) {
    overflow_ = true;
    return;
  }
  put({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

void SentenceWriter::integer(const std::optional<int>& value, int width) {
  put(',');
  if (!value) return;
  if (*value < 0) put('-');
  put_padded(std::abs(static_cast<std::int64_t>(*value)), width);
}

void SentenceWriter::hexadecimal(const std::optional<int>& digit) {
  put(',');
  if (digit && *digit >= 0 && *digit < 16) put("0123456789ABCDEF"[*digit]);
}

void SentenceWriter::angle(const std::optional<double>& radians, int decimals) {
  number(degrees(radians), decimals);
}

void SentenceWriter::latitude(const std::optional<double>& radians, int decimals_of_minute) {
  coordinate(radians, 2, decimals_of_minute, "NS");
}

void SentenceWriter::longitude(const std::optional<double>& radians, int decimals_of_minute) {
  coordinate(radians, 3, decimals_of_minute, "EW");
}

void SentenceWriter::coordinate(const std::optional<double>& radians, int degree_width,
                                int decimals, std::string_view hemispheres) {
  if (!radians) return put(",,");
  // In whole units of the last digit, so that 59.999... minutes carry into the degrees.
  const auto unit = static_cast<std::int64_t>(powers_of_ten[static_cast<std::size_t>(decimals)]);
  const std::int64_t units =
      std::llround(std::abs(degrees(*radians)) * 60.0 * static_cast<double>(unit));
  put(',');
  put_padded(units / (60 * unit), degree_width);
  put_padded(units / unit % 60, 2);
  if (decimals > 0) {
    put('.');
    put_padded(units % unit, decimals);
  }
  put(',');
  put(hemispheres[*radians < 0]);
}

void SentenceWriter::time(const std::optional<std::chrono::nanoseconds>& time_of_day,
                          int decimals) {
  put(',');
  constexpr std::int64_t day_s = 86400, second_ns = 1'000'000'000;
  const std::int64_t ns = time_of_day ? time_of_day->count() : -1;
  if (ns < 0 || ns >= (day_s + 1) * second_ns) return;
  const auto unit = static_cast<std::int64_t>(powers_of_ten[static_cast<std::size_t>(decimals)]);
  const std::int64_t ns_per_unit = second_ns / unit;
  // Rounding must not pass midnight, or the leap second: the date would be wrong.
  const std::int64_t last_unit = (ns < day_s * second_ns ? day_s : day_s + 1) * unit - 1;
  const std::int64_t units = std::min((ns + ns_per_unit / 2) / ns_per_unit, last_unit);
  const std::int64_t whole_seconds = units / unit;
  const bool leap = whole_seconds >= day_s;
  put_padded(leap ? 23 : whole_seconds / 3600, 2);
  put_padded(leap ? 59 : whole_seconds / 60 % 60, 2);
  put_padded(leap ? 60 : whole_seconds % 60, 2);
  if (decimals > 0) {
    put('.');
    put_padded(units % unit, decimals);
  }
}

std::size_t SentenceWriter::finish() {
  std::uint8_t checksum = 0;
  for (std::size_t i = 1; i < size_; ++i) checksum ^= out_[i];
  constexpr std::string_view hex = "0123456789ABCDEF";
  put('*');
  put(hex[checksum >> 4]);
  put(hex[checksum & 15]);
  put("\r\n");
  return overflow_ ? 0 : size_;
}

void SentenceWriter::put(char c) {
  if (size_ == out_.size()) {
    overflow_ = true;
    return;
  }
  out_[size_++] = static_cast<std::uint8_t>(c);
}

void SentenceWriter::put(std::string_view text) {
  for (const char c : text) put(c);
}

void SentenceWriter::put_padded(std::int64_t value, int width) {
  std::array<char, 20> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  for (auto written = end - digits.data(); written < width; ++written) put('0');
  put({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

}  // namespace drydock::wire
