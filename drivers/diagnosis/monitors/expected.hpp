#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

#include "drivers/measurement/kind.hpp"
#include "drivers/wire/protocols.hpp"

namespace drydock::diagnosis {

/// What is known beforehand about a healthy device.
struct Expected {
  std::uint16_t device = 0;  ///< index in the rig
  measurement::Kind kind = measurement::Kind::imu;
  wire::Protocol protocol{};   ///< checksum, own clock, bytes or frames
  double nominal_rate_hz = 0;  ///< 0: not known
  /// White noise of its grade, 1 sigma of a sample; 0: not known. The second one is that of a
  /// receiver's velocity.
  double noise = 0, second_noise = 0;
  double line_bytes_per_second = 0;  ///< that its serial line carries; 0: not known
  std::chrono::nanoseconds stale_after = std::chrono::seconds{2};  ///< silence that is none yet
  std::string_view port_advice{};  ///< for a lost port; empty: that of the cause
  std::uint8_t address = 0;        ///< on a bus; 0: not known
  /// The bus monitor watches when its frames come; its measurements only tell its clock.
  bool times_on_bus = false;
};

}  // namespace drydock::diagnosis
