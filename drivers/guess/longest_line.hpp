#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::guess {

/// The key of a description whose lines are longer than texts usually may be, with room for longer
/// ones than came; empty: none is.
inline std::string longest_key(const std::vector<std::string_view>& lines) {
  constexpr std::size_t usual = 256, most = 8192, line_end = 2;
  std::size_t longest = 0;
  for (const std::string_view line : lines) longest = std::max(longest, line.size() + line_end);
  if (longest < usual) return {};
  return fmt::format("longest = {}\n", std::min(std::bit_ceil(longest + longest / 2), most));
}

}  // namespace drydock::guess
