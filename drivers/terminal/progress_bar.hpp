#pragma once

#include <algorithm>
#include <string>

namespace drydock::terminal {

/// Moves the cursor to the start of the terminal's line and erases the line.
inline constexpr const char* wipe_line = "\r\033[2K";
/// Then the same with the line above it.
inline constexpr const char* wipe_line_above = "\033[A\033[2K";

/// `[#####.....]` for a fraction of work from 0 to 1.
inline std::string progress_bar(double done) {
  constexpr double width = 30;
  const auto full = static_cast<std::size_t>(width * std::clamp(done, 0.0, 1.0));
  return "[" + std::string(full, '#') + std::string(static_cast<std::size_t>(width) - full, '.') +
         "]";
}

}  // namespace drydock::terminal
