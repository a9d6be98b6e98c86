#pragma once

#include <cstdint>

#include "drivers/wire/codec.hpp"

/// RTCM 3 corrections (RTCM 10403.3, chapter 4): D3, six zero bits, length (10 bits), payload,
/// CRC-24Q over all of it. Drydock does not use their content. It must know their frames, so that
/// it does not take bytes inside one for a sync of another protocol.
namespace drydock::wire::rtcm3 {

constexpr std::uint8_t preamble = 0xD3;
constexpr std::size_t header_size = 3, crc_size = 3;
constexpr std::size_t max_frame = header_size + 1023 + crc_size;

/// Polynomial 1864CFB, initial value 0.
std::uint32_t crc24q(Bytes bytes);

/// Classifies the first bytes. They begin with the preamble.
Scan scan(Bytes bytes);

}  // namespace drydock::wire::rtcm3
