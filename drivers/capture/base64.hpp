#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace drydock::capture {

/// Bytes of a text in base64 (RFC 4648, section 4), into the front of `out`. The padding at its end
/// may be left out (section 3.2). Empty: it is none, was cut inside a byte, or does not fit.
inline std::optional<std::size_t> decode_base64(std::string_view text,
                                                std::span<std::uint8_t> out) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto digits = text.substr(0, text.find('='));
  const auto padding = text.substr(digits.size());
  if (!padding.empty() && (text.size() % 4 != 0 || (padding != "=" && padding != "==")))
    return std::nullopt;
  std::size_t size = 0;
  std::uint32_t bits = 0;
  unsigned held = 0;
  for (const char letter : digits) {
    const auto value = letters.find(letter);
    if (value == letters.npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    if (size == out.size()) return std::nullopt;
    out[size++] = static_cast<std::uint8_t>(bits >> held);
  }
  const bool whole = held < 6 && (bits & ((1U << held) - 1)) == 0;  // what fills the last digit
  return whole ? std::optional(size) : std::nullopt;
}

}  // namespace drydock::capture
