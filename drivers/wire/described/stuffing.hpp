#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "drivers/wire/codec.hpp"

/// Packets between delimiters: bytes of a packet that look like one are stuffed, so that it never
/// stands inside. A frame here is what travels, with its delimiters; a packet is what it says.
namespace drydock::wire::described {

inline constexpr std::size_t longest_frame = 8192;

enum class Stuffing : std::uint8_t {
  none,
  dle,   ///< 10h, the packet with each 10h doubled, 10h 03h: Trimble TSIP, Garmin, Actisense
  slip,  ///< RFC 1055: C0h ends a packet; DBh DCh is C0h, DBh DDh is DBh
  hdlc,  ///< RFC 1662: 7Eh ends a packet; behind 7Dh bit 5 of a byte is turned
  cobs   ///< Cheshire and Baker, 1999: 0 ends a packet; a byte tells the distance to the next 0
};

using Packet = boost::container::static_vector<std::uint8_t, longest_frame>;

/// Where the first frame of a line ends: frame(size), need_more(), or bytes to skip. Of `slip`,
/// `hdlc` and `cobs` delimiters may stand before the packet too; one may be between two packets.
Scan delimit(Stuffing stuffing, Bytes bytes, std::size_t longest);

/// The packet of a frame of delimit(). False: its bytes were not stuffed so.
bool unstuff(Stuffing stuffing, Bytes frame, Packet& packet);

/// Writes the frame of a packet. Returns its bytes; 0: it does not fit.
std::size_t stuff(Stuffing stuffing, Bytes packet, std::span<std::uint8_t> out);

}  // namespace drydock::wire::described
