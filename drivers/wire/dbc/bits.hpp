#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dbc/database.hpp"

/// The bits of one signal in a payload of at least layout.bytes_needed() bytes, a byte at a time.
namespace drydock::wire::dbc {

constexpr unsigned lowest_bits(unsigned count) { return (1u << count) - 1; }

/// Calls `part(byte, shift, count)` for the bits of each byte. Intel: the lowest part first.
/// Motorola: the highest.
template <class Part>
void for_each_part(const Layout& layout, Part&& part) {
  const bool intel = layout.order == ByteOrder::intel;
  unsigned bit = layout.start % 8, left = layout.bits;
  for (std::size_t byte = layout.start / 8; left > 0; ++byte) {
    const unsigned count = std::min(intel ? 8 - bit : bit + 1, left);
    part(byte, intel ? bit : bit + 1 - count, count);
    left -= count;
    bit = intel ? 0 : 7;
  }
}

inline std::uint64_t load_bits(Bytes payload, const Layout& layout) {
  std::uint64_t value = 0;
  unsigned done = 0;
  for_each_part(layout, [&](std::size_t byte, unsigned shift, unsigned count) {
    const std::uint64_t bits = payload[byte] >> shift & lowest_bits(count);
    value = layout.order == ByteOrder::intel ? value | bits << done : value << count | bits;
    done += count;
  });
  return value;
}

/// A payload of at most eight bytes as two integers: then a signal is two shifts away.
class PayloadWord {
 public:
  explicit PayloadWord(Bytes payload) {
    for (std::size_t i = 0; i < payload.size(); ++i)
      little_ |= std::uint64_t{payload[i]} << (8 * i);
    big_ = __builtin_bswap64(little_);
  }

  std::uint64_t bits(const Layout& layout) const {
    const unsigned unused = 64 - layout.bits;  // a signal has at least one bit
    const unsigned from_the_top = layout.start / 8 * 8 + 7 - layout.start % 8;
    return layout.order == ByteOrder::intel ? little_ >> layout.start << unused >> unused
                                            : big_ << from_the_top >> unused;
  }

 private:
  std::uint64_t little_ = 0, big_ = 0;
};

/// Leaves the other bits as they are.
inline void store_bits(std::span<std::uint8_t> payload, const Layout& layout, std::uint64_t value) {
  unsigned left = layout.bits;
  for_each_part(layout, [&](std::size_t byte, unsigned shift, unsigned count) {
    left -= count;
    const bool intel = layout.order == ByteOrder::intel;
    const std::uint64_t bits = value >> (intel ? layout.bits - left - count : left);
    const unsigned mask = lowest_bits(count) << shift;
    payload[byte] = static_cast<std::uint8_t>((payload[byte] & ~mask) | (bits << shift & mask));
  });
}

}  // namespace drydock::wire::dbc
