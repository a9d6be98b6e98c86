#pragma once

#include <array>
#include <cstdint>

/// The usual form of a number in a text, which is read in a fraction of the time of any form.
namespace drydock::wire {

constexpr bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

inline constexpr std::array<double, 16> powers_of_ten{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                      1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// An optional minus, digits, at most one point.
struct PlainNumber {
  std::int64_t mantissa = 0;
  int digits = 0, decimals = 0;
  bool whole = true;          ///< no point
  const char* end = nullptr;  ///< the character here decides whether the field is such a number

  bool is_int() const { return whole && digits > 0 && digits < 10; }
  /// With up to 15 digits, the quotient of two exact doubles is the correctly rounded value.
  bool is_exact() const { return digits > 0 && digits < 16; }
  double value() const {
    const auto exact = static_cast<double>(mantissa);
    return whole ? exact : exact / powers_of_ten[static_cast<std::size_t>(decimals)];
  }
};

inline PlainNumber plain_number(const char* at, const char* const stop) {
  const bool negative = at != stop && *at == '-';
  if (negative) ++at;
  std::uint64_t mantissa = 0;
  const auto take_digits = [&] {
    const char* const start = at;
    for (; at != stop && is_decimal_digit(*at); ++at) {
      mantissa = mantissa * 10 + static_cast<unsigned>(*at - '0');
    }
    return static_cast<int>(at - start);
  };
  PlainNumber number;
  number.digits = take_digits();
  if (at != stop && *at == '.') {
    ++at;
    number.whole = false;
    number.decimals = take_digits();
    number.digits += number.decimals;
  }
  // The mantissa is unsigned, since digits after the 19th may wrap to any value. is_exact() then
  // excludes it.
  number.mantissa = static_cast<std::int64_t>(negative ? 0 - mantissa : mantissa);
  number.end = at;
  return number;
}

}  // namespace drydock::wire
