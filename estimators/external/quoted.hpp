#pragma once

#include <fmt/format.h>

#include <string_view>

#include "drivers/text/printable.hpp"

namespace drydock::external {

/// The beginning of a line of the other program, as people may read it.
inline std::string quoted(std::string_view line) {
  constexpr std::size_t shown = 80;
  return fmt::format("\"{}\"", text::printable(line.substr(0, shown)));
}

}  // namespace drydock::external
