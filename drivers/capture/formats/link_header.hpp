#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// What a packet of a network interface carries, behind the header of its link type
/// (tcpdump.org/linktypes.html).
struct LinkPayload {
  std::uint16_t protocol = 0;  ///< an EtherType
  wire::Bytes bytes;
  std::uint32_t interface = 0;  ///< index on the computer that recorded it; 0: not said
};

inline constexpr std::uint16_t protocol_ipv4 = 0x0800, protocol_ipv6 = 0x86DD,
                               protocol_can = 0x000C, protocol_can_fd = 0x000D;
inline constexpr std::uint32_t linktype_linux_sll = 113, linktype_linux_sll2 = 276;

/// Ethernet, raw IP, loopback and Linux cooked captures (SLL, SLL2).
bool is_network_link(std::uint32_t link_type);

/// True if such an interface can also be a CAN bus: `tcpdump -i any` gives cooked packets.
constexpr bool is_cooked_link(std::uint32_t link_type) {
  return link_type == linktype_linux_sll || link_type == linktype_linux_sll2;
}

/// Empty: another link type, or the packet is cut short.
std::optional<LinkPayload> link_payload(std::uint32_t link_type, wire::Bytes packet);

}  // namespace drydock::capture
