#pragma once

#include <cstdint>
#include <span>

#include "drivers/wire/codec.hpp"

/// The frame of Nortek's AD2CP records: a header of 10 bytes, or of 12 for data of more than 64 kB,
/// with a sum of the data and a sum of itself. Source: Nortek, Signature Integrator's Guide 2017.
namespace drydock::wire::ad2cp {

struct Header {
  std::size_t size = 0;  ///< of the header itself, bytes
  std::uint8_t id = 0;
  std::uint8_t family = 0;  ///< of the instrument
  std::size_t data_size = 0;
};

inline constexpr std::uint8_t dvl_family = 0x10, nucleus_family = 0x20;
inline constexpr std::size_t short_header = 10;

/// `frame` begins with a whole header.
Header read_header(Bytes frame);

/// A record may have up to `longest` bytes. Both sums must be right.
Scan scan_record(Bytes bytes, std::size_t longest);

/// B58C plus the 16-bit words of the bytes; an odd last byte is the high byte of its word.
std::uint16_t word_sum(Bytes bytes);

/// Writes the short header before the data that stand at out[10]. Returns the bytes of the record.
std::size_t close_record(std::uint8_t id, std::uint8_t family, std::size_t data_size,
                         std::span<std::uint8_t> out);

}  // namespace drydock::wire::ad2cp
