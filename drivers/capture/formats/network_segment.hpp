#pragma once

#include <optional>
#include <string>

#include "drivers/capture/formats/link_header.hpp"

namespace drydock::capture {

/// What one packet adds to a conversation: a datagram of UDP, or a piece of a TCP stream.
struct NetworkSegment {
  std::string sender, receiver;  ///< address and port: `192.168.2.95:16171`, `[fe80::1]:9002`
  bool stream = false;           ///< TCP
  std::uint32_t sequence = 0;    ///< TCP: number of the first byte
  bool begins = false;           ///< TCP: the connection opens; its first byte is sequence + 1
  wire::Bytes payload;
};

/// The sender's address, without a port, of a piece of an IPv6 packet: it is not put together.
/// Empty: the packet is whole, or is another's.
std::string sender_of_fragment(const LinkPayload& packet);

std::string ipv4_address(wire::Bytes address);

/// Empty: neither TCP nor UDP, a fragment behind the first, or cut short in its headers. Of a
/// packet cut short in its payload that which is there.
std::optional<NetworkSegment> network_segment(const LinkPayload& packet);

}  // namespace drydock::capture
