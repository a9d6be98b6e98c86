#pragma once

#include <chrono>

namespace drydock::external {

/// After so many times the allowed time without an answer a program is given up.
inline constexpr int patience_factor = 5;
/// Interpreters take their time to start.
inline constexpr std::chrono::seconds to_greet{10};

inline double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace drydock::external
