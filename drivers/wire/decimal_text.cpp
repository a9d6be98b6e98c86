#include "drivers/wire/decimal_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

namespace drydock::wire {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr auto powers = [] {
  std::array<std::uint64_t, 19> all{1};
  for (std::size_t i = 1; i < all.size(); ++i) all[i] = 10 * all[i - 1];
  return all;
}();
constexpr int most_decimals = 15;  // 53 bits times 10^15 have 103 bits

constexpr std::uint64_t power(int exponent) { return powers[static_cast<std::size_t>(exponent)]; }

/// |value| times a power of ten, rounded to even. Empty: it has more than 18 digits.
std::optional<std::uint64_t> scaled(double value, int decimals) {
  constexpr int mantissa_bits = 52, bias = 1075;
  constexpr std::uint64_t hidden = std::uint64_t{1} << mantissa_bits;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>(bits >> mantissa_bits & 0x7FF);
  const std::uint64_t fraction = bits & (hidden - 1);
  const std::uint64_t mantissa = biased == 0 ? fraction : fraction | hidden;
  const int shift = bias - (biased == 0 ? 1 : biased);
  if (shift <= 0) return {};
  if (shift > 120) return 0;  // less than half of the last place
  const Wide product = Wide{mantissa} * power(decimals), half = Wide{1} << (shift - 1);
  const Wide whole = product >> shift, rest = product - (whole << shift);
  if (whole >= power(18)) return {};
  const auto down = static_cast<std::uint64_t>(whole);
  return down + (rest > half || (rest == half && down % 2 == 1) ? 1 : 0);
}

char* put_digits(std::uint64_t digits, int decimals, bool negative, char* out) {
  if (negative) *out++ = '-';
  out = std::to_chars(out, out + 20, digits / power(decimals)).ptr;
  if (decimals == 0) return out;
  *out++ = '.';
  std::fill_n(out, decimals, '0');
  std::uint64_t rest = digits % power(decimals);
  for (int place = decimals - 1; rest != 0; --place, rest /= 10)
    out[place] = static_cast<char>('0' + rest % 10);
  return out + decimals;
}

}  // namespace

char* fixed_text(double value, int decimals, char* out) {
  if (decimals >= 0 && decimals <= most_decimals)
    if (const auto digits = scaled(value, decimals))
      return put_digits(*digits, decimals, std::signbit(value), out);
  const auto [end, error] =
      std::to_chars(out, out + decimal_text_size, value, std::chars_format::fixed, decimals);
  return error == std::errc{} ? end : nullptr;
}

char* general_text(double value, char* out) {
  constexpr int significant = 9;
  // None of these doubles is below its power of ten. Between the first and the last a text has no
  // exponent.
  constexpr std::array decades{1e-4, 1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
  const double size = std::abs(value);
  if (size == 0) return put_digits(0, 0, std::signbit(value), out);
  if (size >= decades.front() && size < decades.back()) {
    int decimals = significant + 3;
    for (std::size_t i = 1; size >= decades[i]; ++i) --decimals;
    std::uint64_t digits = *scaled(value, decimals);
    for (; decimals > 0 && digits % 10 == 0; --decimals) digits /= 10;
    return put_digits(digits, decimals, std::signbit(value), out);
  }
  return std::to_chars(out, out + decimal_text_size, value, std::chars_format::general, significant)
      .ptr;
}

}  // namespace drydock::wire
