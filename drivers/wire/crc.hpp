#pragma once

#include <array>
#include <cstdint>

#include "drivers/wire/codec.hpp"

/// Cyclic redundancy checks by their usual parameters.
namespace drydock::wire {

struct CrcParameters {
  unsigned width = 8;  ///< bits, at least 8
  std::uint64_t polynomial = 0;
  std::uint64_t initial = 0;
  bool reflected = false;  ///< input and output
  std::uint64_t final_xor = 0;
};

class Crc {
 public:
  constexpr explicit Crc(const CrcParameters& parameters) : p_(parameters), table_(make_table()) {}

  constexpr std::uint64_t operator()(Bytes bytes) const { return finish(add(start(), bytes)); }

  /// In parts: finish(add(add(start(), a), b)).
  constexpr std::uint64_t start() const {
    return p_.reflected ? mirrored(p_.initial, p_.width) : p_.initial;
  }
  constexpr std::uint64_t add(std::uint64_t state, Bytes bytes) const {
    for (const std::uint8_t byte : bytes) {
      const auto at = (p_.reflected ? state : state >> (p_.width - 8)) ^ byte;
      state = (p_.reflected ? state >> 8 : state << 8 & mask()) ^ table_[at & 0xFF];
    }
    return state;
  }
  constexpr std::uint64_t finish(std::uint64_t state) const { return state ^ p_.final_xor; }

 private:
  constexpr std::uint64_t mask() const { return ~std::uint64_t{0} >> (64 - p_.width); }

  static constexpr std::uint64_t mirrored(std::uint64_t value, unsigned bits) {
    std::uint64_t turned = 0;
    for (unsigned i = 0; i < bits; ++i) turned = turned << 1 | (value >> i & 1);
    return turned;
  }

  constexpr std::array<std::uint64_t, 256> make_table() const {
    std::array<std::uint64_t, 256> table{};
    for (std::uint64_t byte = 0; byte < 256; ++byte) table[byte] = of_byte(byte);
    return table;
  }

  constexpr std::uint64_t of_byte(std::uint64_t byte) const {
    if (p_.reflected) return mirrored(divided(mirrored(byte, 8)), p_.width);
    return divided(byte);
  }

  /// The remainder of eight bits.
  constexpr std::uint64_t divided(std::uint64_t byte) const {
    std::uint64_t state = byte << (p_.width - 8);
    for (int i = 0; i < 8; ++i) {
      const bool top = (state >> (p_.width - 1) & 1) != 0;
      state = (state << 1 & mask()) ^ (top ? p_.polynomial : 0);
    }
    return state;
  }

  CrcParameters p_;
  std::array<std::uint64_t, 256> table_;
};

}  // namespace drydock::wire
