#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

/// What stands in a capture, told by sync, length and checksum alone: simpler than the decoders
/// and apart from them, so that neither hides the other's loss.
namespace drydock::conformance {

/// Frames 7F 7F with their length and a good sum.
std::vector<std::string_view> scan_pd0(std::string_view bytes);

/// Payload position B5 62 class id, good Fletcher sums; whole frames.
std::vector<std::string_view> scan_ubx(std::string_view bytes);

/// `$....*hh` of printable characters with a good XOR, without the checksum.
std::vector<std::string_view> scan_nmea(std::string_view bytes);

constexpr unsigned octet(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}
constexpr unsigned pair_le(std::string_view bytes, std::size_t at) {
  return octet(bytes, at) | octet(bytes, at + 1) << 8;
}

}  // namespace drydock::conformance
