#include "drivers/text/json_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

namespace drydock::text {
namespace {

constexpr auto digit_pairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

/// Writes `Digits` digits, with leading zeros.
template <int Digits>
void write_digits(char* at, std::uint64_t whole) {
  if constexpr (Digits == 1) {
    *at = static_cast<char>('0' + whole);
  } else {
    std::memcpy(at + Digits - 2, digit_pairs.data() + 2 * (whole % 100), 2);
    if constexpr (Digits > 2) write_digits<Digits - 2>(at, whole / 100);
  }
}

char* write_whole(char* at, std::uint64_t whole) {
  if (whole > 99) return std::to_chars(at, at + longest_number, whole).ptr;
  if (whole > 9) *at++ = digit_pairs[2 * whole];
  *at++ = digit_pairs[2 * whole + 1];
  return at;
}

/// Writes `whole` / 10^`Decimals`, which is not an integer, without zeros at the end.
template <int Decimals, std::uint64_t Unit>
char* write_decimal(char* at, std::uint64_t whole) {
  at = write_whole(at, whole / Unit);
  *at++ = '.';
  write_digits<Decimals>(at, whole % Unit);
  at += Decimals;
  while (at[-1] == '0') --at;
  return at;
}

/// Gives n if `magnitude` is n / `Unit`. A decimal of up to 15 digits reads back as n / `Unit`:
/// both are exact and the quotient is rounded once. No other decimal that short reads back so.
/// Therefore its digits are the fewest for this number.
template <std::uint64_t Unit>
std::optional<std::uint64_t> whole_number(double magnitude) {
  constexpr double unit = Unit;
  if (magnitude >= 1e15 / unit) return {};
  const auto whole = static_cast<std::int64_t>(magnitude * unit + (Unit == 1 ? 0 : 0.5));
  if (static_cast<double>(whole) / unit != magnitude) return {};
  return static_cast<std::uint64_t>(whole);
}

}  // namespace

char* JsonText::grow(char* at, std::size_t size) {
  const auto written = static_cast<std::size_t>(at - text_.get());
  const auto capacity =
      std::max(2 * static_cast<std::size_t>(limit_ - text_.get()), written + size);
  std::unique_ptr<char[]> text(new char[capacity]);
  std::memcpy(text.get(), text_.get(), written);
  text_ = std::move(text);
  limit_ = text_.get() + capacity;
  return text_.get() + written;
}

char* write_number(char* at, double number) {
  const double magnitude = std::abs(number);
  *at = '-';
  at += std::signbit(number);
  // Most values from a wire are an integer divided by some power of ten.
  if (const auto whole = whole_number<1>(magnitude)) return write_whole(at, *whole);
  if (const auto milli = whole_number<1'000>(magnitude)) return write_decimal<3, 1'000>(at, *milli);
  if (const auto ten_millionth = whole_number<10'000'000>(magnitude))
    return write_decimal<7, 10'000'000>(at, *ten_millionth);
  // A smaller one may be shorter with an exponent.
  if (magnitude >= 1e-4)
    if (const auto nano = whole_number<1'000'000'000>(magnitude))
      return write_decimal<9, 1'000'000'000>(at, *nano);
  return std::to_chars(at, at + longest_number, magnitude).ptr;
}

char* write_number(char* at, std::uint64_t number) { return write_whole(at, number); }

char* write_number(char* at, std::int64_t number) {
  *at = '-';
  at += number < 0;
  return write_whole(
      at, number < 0 ? 0 - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number));
}

char* write_number(char* at, float number) {
  return std::to_chars(at, at + longest_number, number).ptr;
}

}  // namespace drydock::text
