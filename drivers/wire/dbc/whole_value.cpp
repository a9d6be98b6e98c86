#include "drivers/wire/dbc/whole_value.hpp"

#include <cmath>
#include <limits>

namespace drydock::wire::dbc {

namespace {

__extension__ using Wide = __int128;

/// Below 2^62, so that 64 bits times the factor and then the offset fit in 128 bits.
bool is_whole(double number) { return std::abs(number) < 0x1p62 && std::trunc(number) == number; }

}  // namespace

std::optional<WholeNumber> whole_value(const Value& value, const Layout& layout) {
  if (layout.is_float() || !is_whole(layout.factor) || !is_whole(layout.offset)) return {};
  const Wide raw = layout.number == Number::signed_integer
                       ? Wide{static_cast<std::int64_t>(value.raw)}
                       : Wide{value.raw};
  const Wide physical =
      raw * static_cast<std::int64_t>(layout.factor) + static_cast<std::int64_t>(layout.offset);
  if (physical < 0) {
    if (physical < std::numeric_limits<std::int64_t>::min()) return {};
    return static_cast<std::int64_t>(physical);
  }
  if (physical > std::numeric_limits<std::uint64_t>::max()) return {};
  return static_cast<std::uint64_t>(physical);
}

}  // namespace drydock::wire::dbc
