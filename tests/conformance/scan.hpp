#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

/// Finds the frames in a capture by sync, length and checksum alone. These scanners are simpler
/// than the decoders and independent of them, so that neither can hide losses of the other.
namespace drydock::conformance {

/// Frames 7F 7F with their length and a right sum.
std::vector<std::string_view> scan_pd0(std::string_view bytes);

/// Records A5 with the short or the long header, whose two sums are right.
std::vector<std::string_view> scan_ad2cp(std::string_view bytes);

/// Frames B5 62 class id with right Fletcher sums, complete.
std::vector<std::string_view> scan_ubx(std::string_view bytes);

/// `$....*hh` of printable characters with a right XOR, without the checksum.
std::vector<std::string_view> scan_nmea(std::string_view bytes);

/// A sentence of a maker's own form, as `$PQGSV`: no talker and formatter stand in it.
constexpr bool is_proprietary(std::string_view sentence) { return sentence.starts_with("$P"); }

constexpr unsigned octet(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}
constexpr unsigned pair_le(std::string_view bytes, std::size_t at) {
  return octet(bytes, at) | octet(bytes, at + 1) << 8;
}

}  // namespace drydock::conformance
