#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace drydock::wire {

/// One CAN or CAN FD frame in the view of software, for every adapter.
struct CanFrame {
  std::uint32_t id = 0;   ///< 11 or 29 bits, without flags; for an error frame the error class
  bool extended = false;  ///< 29-bit identifier
  bool remote = false;
  bool error = false;  ///< error frame of the controller (linux/can/error.h)
  bool fd = false;
  bool bit_rate_switch = false;
  std::uint8_t size = 0;  ///< bytes of data, 0..8, CAN FD 0..64
  std::array<std::uint8_t, 64> data{};

  std::span<const std::uint8_t> payload() const { return {data.data(), size}; }

  friend bool operator==(const CanFrame& a, const CanFrame& b) {
    return a.id == b.id && a.extended == b.extended && a.remote == b.remote && a.error == b.error &&
           a.fd == b.fd && a.bit_rate_switch == b.bit_rate_switch && a.size == b.size &&
           std::equal(a.data.begin(), a.data.begin() + a.size, b.data.begin());
  }
};

}  // namespace drydock::wire
