#pragma once

#include <cstdint>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/codec.hpp"

/// Sums over bytes, eight at a time: they determine the speed of a scanner.
namespace drydock::wire {

/// The even and odd bytes of a word in lanes of 16 bits. Small products and sums do not overflow
/// there.
struct ByteLanes {
  std::uint64_t even, odd;
  constexpr explicit ByteLanes(std::uint64_t word)
      : even(word & 0x00FF'00FF'00FF'00FF), odd(word >> 8 & 0x00FF'00FF'00FF'00FF) {}
};

/// Sum of the four lanes: the top lane of the product.
constexpr std::uint32_t lane_sum(std::uint64_t lanes) {
  return static_cast<std::uint32_t>(lanes * 0x0001'0001'0001'0001 >> 48);
}

/// Sum of all bytes modulo 2^32.
inline std::uint32_t byte_total(Bytes bytes) {
  std::uint32_t total = 0;
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
    const ByteLanes lanes{load_le<std::uint64_t>(bytes, 0)};
    total += lane_sum(lanes.even + lanes.odd);
  }
  for (const std::uint8_t byte : bytes) total += byte;
  return total;
}

/// Sum of all bytes modulo 65536.
inline std::uint16_t byte_sum(Bytes bytes) { return static_cast<std::uint16_t>(byte_total(bytes)); }

/// 8-bit Fletcher sum (RFC 1145). The low byte is the sum of the bytes; the high byte is the sum of
/// all intermediate sums.
inline std::uint16_t fletcher8(Bytes bytes) {
  std::uint32_t a = 0, b = 0;
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
    // Of eight bytes, the first counts eight times in the second sum and the last counts once.
    const ByteLanes lanes{load_le<std::uint64_t>(bytes, 0)};
    const std::uint64_t weighted =
        lanes.even * 0x0008'0006'0004'0002 + lanes.odd * 0x0007'0005'0003'0001;
    b += 8 * a + static_cast<std::uint32_t>(weighted >> 48);
    a += lane_sum(lanes.even + lanes.odd);
  }
  for (const std::uint8_t byte : bytes) {
    a += byte;
    b += a;
  }
  return static_cast<std::uint16_t>((a & 0xFF) | (b & 0xFF) << 8);
}

/// XOR of the eight bytes of a word.
constexpr std::uint8_t xor_of_bytes(std::uint64_t word) {
  word ^= word >> 32;
  word ^= word >> 16;
  return static_cast<std::uint8_t>(word ^ word >> 8);
}

}  // namespace drydock::wire
