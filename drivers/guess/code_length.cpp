#include "drivers/guess/code_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drydock::guess {

/// The estimate is method C of A. Moffat, Implementing the PPM data compression scheme, IEEE
/// Transactions on Communications 38, 1990.
double bits_of_symbols(std::span<const std::uint8_t> symbols, double new_bits) {
  std::array<std::uint32_t, 256> counts{};
  double bits = 0, seen = 0, kinds = 0;
  for (const std::uint8_t symbol : symbols) {
    const double count = counts[symbol]++;
    const double share = count > 0 ? count : std::max(kinds, 1.0);
    bits += std::log2(std::max(seen + kinds, 1.0) / share) + (count > 0 ? 0 : new_bits);
    kinds += count > 0 ? 0 : 1;
    ++seen;
  }
  return bits;
}

std::uint8_t binary_digits(double magnitude) {
  constexpr int most = 63;
  if (!(magnitude >= 0.5)) return 0;
  return static_cast<std::uint8_t>(std::min(std::ilogb(std::max(magnitude, 1.0)) + 1, most));
}

double bits_of_residuals(std::span<const std::uint8_t> digits) {
  constexpr double bits_of_a_new_length = 6;
  double bits = bits_of_symbols(digits, bits_of_a_new_length);
  for (const std::uint8_t one : digits) bits += one;  // the digits but for the first, and a sign
  return bits;
}

}  // namespace drydock::guess
