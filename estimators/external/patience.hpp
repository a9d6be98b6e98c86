#pragma once

#include <chrono>

namespace drydock::external {

/// After so many times the allowed time without an answer a program is given up.
inline constexpr int patience_factor = 5;
/// A program that loads a large library from a cold disk takes long to start. One that ends instead
/// is seen at once.
inline constexpr std::chrono::seconds to_greet{60};
/// A node of the bus that was started before the run is discovered within a second or two.
inline constexpr std::chrono::seconds to_meet{10};

inline double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace drydock::external
