#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "hil/emulate/ublox/ublox_items.hpp"

/// The messages of a receiver about itself, as whole frames. Sources: as ublox_items.hpp. Each
/// returns the bytes of the frame, 0 if `out` is too small.
namespace drydock::emulate::ublox {

/// Software, hardware and extensions of a NEO-M8N (SPG 3.01) or of a ZED-F9P (HPG 1.13).
std::size_t encode_version(Model model, std::span<std::uint8_t> out);

/// A healthy antenna and no jamming.
std::size_t encode_hardware(std::span<std::uint8_t> out);
std::size_t encode_hardware_2(std::span<std::uint8_t> out);

/// The same of an F9, for each of its two bands.
inline constexpr std::uint16_t mon_rf = 0x0A38;
std::size_t encode_radio(std::span<std::uint8_t> out);

/// No edge has come at the input EXTINT.
std::size_t encode_time_mark(std::span<std::uint8_t> out);

}  // namespace drydock::emulate::ublox
