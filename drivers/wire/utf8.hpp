#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace drydock::wire {

/// Bytes of the UTF-8 character at the front; 0 if none is there. RFC 3629: neither longer than
/// necessary, nor a surrogate, nor beyond U+10FFFF.
inline std::size_t utf8_at_front(std::string_view bytes) {
  const auto byte = [](char c) { return static_cast<std::uint8_t>(c); };
  if (bytes.empty()) return 0;
  const std::uint8_t first = byte(bytes[0]);
  if (first < 0x80) return 1;
  const std::size_t size = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (size == 0 || first > 0xF4 || bytes.size() < size) return 0;
  const std::uint8_t lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const std::uint8_t highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byte(bytes[1]) < lowest || byte(bytes[1]) > highest) return 0;
  const auto continues = [&](char c) { return (byte(c) & 0xC0) == 0x80; };
  return std::ranges::all_of(bytes.substr(2, size - 2), continues) ? size : 0;
}

}  // namespace drydock::wire
