#pragma once

#include <array>
#include <cstdint>
#include <span>

/// What has passed the ports of a receiver. A host finds out by it at which port it is. Sources: as
/// ublox_items.hpp.
namespace drydock::emulate::ublox {

inline constexpr std::uint16_t mon_io = 0x0A02, mon_comms = 0x0A36;

/// Of UART1; the other ports lead nowhere.
struct PortTraffic {
  std::uint32_t bytes_in = 0, bytes_out = 0, bytes_skipped = 0;
  std::uint16_t ubx_in = 0, nmea_in = 0;  ///< messages
};

/// Whole frames. Each returns the bytes of the frame, 0 if `out` is too small.
std::size_t encode_io(const PortTraffic& traffic, std::span<std::uint8_t> out);
std::size_t encode_comms(const PortTraffic& traffic, std::span<std::uint8_t> out);

}  // namespace drydock::emulate::ublox
