#include "hil/sky/rinex_fields.hpp"

#include <array>
#include <cmath>

namespace drydock::sky {

std::optional<double> real(std::string_view text) {
  std::array<char, 24> digits{};
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.size() >= digits.size()) return std::nullopt;
  char* end = digits.data();
  for (const char c : text) {
    const bool bare_exponent = (c == '-' || c == '+') && end != digits.data() &&
                               ((end[-1] >= '0' && end[-1] <= '9') || end[-1] == '.');
    if (bare_exponent) *end++ = 'e';
    *end++ = c == 'D' || c == 'd' ? 'e' : c;
  }
  double value = 0;
  const char* begin = digits.data();
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace drydock::sky
