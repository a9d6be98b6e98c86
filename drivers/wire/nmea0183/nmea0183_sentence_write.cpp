#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "drivers/wire/fields.hpp"
#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

namespace drydock::wire {
namespace {

constexpr std::int64_t power_of_ten(int exponent) {
  std::int64_t power = 1;
  while (exponent-- > 0) power *= 10;
  return power;
}

}  // namespace

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
  std::string_view text(digits.data(), static_cast<std::size_t>(end - digits.data()));
  const bool is_zero = text.find_first_of("123456789") == std::string_view::npos;
  if (is_zero && text.starts_with('-')) text.remove_prefix(1);
  put(text);
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

void SentenceWriter::eastward(const std::optional<double>& radians, int decimals) {
  angle(radians ? std::optional{std::abs(*radians)} : std::nullopt, decimals);
  letter(!radians ? Letter{} : Letter{*radians < 0 ? 'W' : 'E'});
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
  // Integers in units of the last digit, so that 59.999... minutes carry into the degrees.
  const std::int64_t unit = power_of_ten(decimals);
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
  const std::int64_t unit = power_of_ten(decimals);
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
