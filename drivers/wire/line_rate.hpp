#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace drydock::wire {

enum class Parity : std::uint8_t { none, even, odd, mark, space };

/// How a serial line frames a byte: a start bit, the data bits, a parity bit, the stop bits.
struct ByteFrame {
  unsigned data_bits = 8;
  Parity parity = Parity::none;
  unsigned stop_bits = 1;

  constexpr unsigned bits() const {
    return 1 + data_bits + (parity == Parity::none ? 0 : 1) + stop_bits;
  }
};

/// The pace of a serial line without a pause between its bytes.
struct LineRate {
  unsigned baud = 0;  ///< bit/s; 0: the line has no rate, and a byte takes no time
  ByteFrame frame;

  constexpr LineRate(unsigned bits_per_second = 0, ByteFrame of_a_byte = {})
      : baud(bits_per_second), frame(of_a_byte) {}

  constexpr double bytes_per_second() const { return static_cast<double>(baud) / frame.bits(); }
  /// Rounded down to whole nanoseconds.
  constexpr std::chrono::nanoseconds time_of(std::size_t bytes) const {
    constexpr std::int64_t ns_per_second = 1'000'000'000;
    if (baud == 0) return {};
    return std::chrono::nanoseconds{static_cast<std::int64_t>(bytes) * frame.bits() *
                                    ns_per_second / baud};
  }
};

}  // namespace drydock::wire
