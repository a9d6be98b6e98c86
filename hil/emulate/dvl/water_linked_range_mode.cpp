#include "hil/emulate/dvl/water_linked_range_mode.hpp"

#include <array>

namespace drydock::emulate {
namespace {

constexpr double unlimited_m = 1e4;
constexpr double water_track_rate_hz = 2;

/// Where the maker gives a range of rates, its middle.
constexpr std::array<RangeMode, 5> fixed_modes{
    {{0.05, 0.6, 15}, {0.3, 3, 10}, {1.5, 14, 5.5}, {7.7, 36, 7.5}, {15, unlimited_m, 3}}};

const RangeMode* fixed_mode(char digit) {
  const auto index = static_cast<std::size_t>(digit - '0');
  return index < fixed_modes.size() ? &fixed_modes[index] : nullptr;
}

}  // namespace

std::optional<RangeMode> range_mode_of(std::string_view text) {
  if (text == "auto") return RangeMode{0, unlimited_m};
  if (text == "wt") return RangeMode{0, unlimited_m, water_track_rate_hz, true};
  const bool one = text.size() == 2 && text[0] == '=';
  const bool several = text.size() == 4 && text.substr(1, 2) == "<=";
  if (!one && !several) return std::nullopt;
  const RangeMode *first = fixed_mode(text[one ? 1 : 0]), *last = fixed_mode(text.back());
  if (!first || !last || first > last) return std::nullopt;
  return one ? *first : RangeMode{first->shortest_m, last->longest_m};
}

}  // namespace drydock::emulate
