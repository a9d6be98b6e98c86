#include "drivers/wire/ubx/rtcm3.hpp"

#include <array>

#include "drivers/wire/bytes.hpp"

namespace drydock::wire::rtcm3 {
namespace {

constexpr auto table = [] {
  std::array<std::uint32_t, 256> remainders{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte << 16;
    for (int bit = 0; bit < 8; ++bit) crc = crc << 1 ^ ((crc & 0x80'0000) != 0 ? 0x186'4CFB : 0);
    remainders[byte] = crc & 0xFF'FFFF;
  }
  return remainders;
}();

}  // namespace

std::uint32_t crc24q(Bytes bytes) {
  std::uint32_t crc = 0;
  for (const std::uint8_t byte : bytes) crc = (crc << 8 ^ table[crc >> 16 ^ byte]) & 0xFF'FFFF;
  return crc;
}

Scan scan(Bytes bytes) {
  if (bytes.size() > 1 && (bytes[1] & 0xFC) != 0) return Scan::skip(1);
  if (bytes.size() < header_size) return Scan::need_more();
  const std::size_t size = (load_be<std::uint16_t>(bytes, 1) & 0x3FFu) + header_size + crc_size;
  if (bytes.size() < size) return Scan::need_more(size);
  // A message followed by its own CRC has remainder zero. Noise often contains such a short sync,
  // so a mismatch does not count as a damaged frame.
  return crc24q(bytes.first(size)) == 0 ? Scan::frame(size) : Scan::skip(1);
}

}  // namespace drydock::wire::rtcm3
