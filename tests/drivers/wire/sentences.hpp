#pragma once

#include <numbers>
#include <numeric>
#include <string>

namespace drydock::wire::testing {

constexpr double arc_minute = std::numbers::pi / 180 / 60;  ///< rad

/// Puts `$`, checksum and line end around a body.
inline std::string sentence(const std::string& body) {
  const int sum = std::accumulate(body.begin(), body.end(), 0, [](int x, char c) { return x ^ c; });
  constexpr const char* hex = "0123456789ABCDEF";
  return "$" + body + "*" + hex[sum / 16] + hex[sum % 16] + "\r\n";
}

}  // namespace drydock::wire::testing
