#pragma once

#include <cstdint>
#include <span>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/checksum.hpp"
#include "drivers/wire/codec.hpp"

/// The UBX frame around a payload.
namespace drydock::wire::ubx {

constexpr std::uint8_t sync_1 = 0xB5, sync_2 = 0x62;
constexpr std::size_t header_size = 6, checksum_size = 2, overhead = header_size + checksum_size;

/// From class to the end of the payload. CK_A of its Fletcher sum comes first on the wire:
/// little-endian.
inline Bytes checked_part(Bytes frame) { return frame.subspan(2, frame.size() - 4); }

/// Writes header and checksum around a payload at `header_size`. Returns the size of the frame.
inline std::size_t wrap(std::span<std::uint8_t> out, std::uint16_t class_and_id,
                        std::size_t payload_size) {
  const auto frame = out.first(payload_size + overhead);
  frame[0] = sync_1;
  frame[1] = sync_2;
  store_be<std::uint16_t>(frame, 2, class_and_id);
  store_le<std::uint16_t>(frame, 4, static_cast<std::uint16_t>(payload_size));
  store_le<std::uint16_t>(frame, frame.size() - checksum_size, fletcher8(checked_part(frame)));
  return frame.size();
}

}  // namespace drydock::wire::ubx
