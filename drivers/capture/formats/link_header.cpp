#include "drivers/capture/formats/link_header.hpp"

#include "drivers/wire/bytes.hpp"

namespace drydock::capture {
namespace {

using wire::Bytes;

constexpr std::uint32_t ethernet = 1, raw_ip = 101, null_loopback = 0, loopback = 108, ipv4 = 228,
                        ipv6 = 229;
constexpr std::uint16_t vlan = 0x8100, service_vlan = 0x88A8;

std::uint16_t half(Bytes bytes, std::size_t at) { return wire::load_be<std::uint16_t>(bytes, at); }

/// IPv4 or IPv6 by the first four bits.
std::optional<LinkPayload> ip_payload(Bytes packet) {
  if (packet.empty()) return {};
  const unsigned version = packet[0] >> 4;
  if (version != 4 && version != 6) return {};
  return LinkPayload{version == 4 ? protocol_ipv4 : protocol_ipv6, packet};
}

std::optional<LinkPayload> ethernet_payload(Bytes packet) {
  std::size_t type_at = 12;
  while (packet.size() >= type_at + 2) {
    const std::uint16_t type = half(packet, type_at);
    if (type != vlan && type != service_vlan) return LinkPayload{type, packet.subspan(type_at + 2)};
    type_at += 4;
  }
  return {};
}

}  // namespace

bool is_network_link(std::uint32_t link_type) {
  return link_type == ethernet || link_type == raw_ip || link_type == null_loopback ||
         link_type == loopback || link_type == ipv4 || link_type == ipv6 ||
         is_cooked_link(link_type);
}

std::optional<LinkPayload> link_payload(std::uint32_t link_type, Bytes packet) {
  constexpr std::size_t sll_header = 16, sll2_header = 20, family = 4;
  switch (link_type) {
    case ethernet: return ethernet_payload(packet);
    case raw_ip:
    case ipv4:
    case ipv6: return ip_payload(packet);
    case null_loopback:  // the family of addresses, whose numbers differ between systems
    case loopback:
      return packet.size() < family ? std::nullopt : ip_payload(packet.subspan(family));
    case linktype_linux_sll:
      if (packet.size() < sll_header) return {};
      return LinkPayload{half(packet, 14), packet.subspan(sll_header)};
    case linktype_linux_sll2:
      if (packet.size() < sll2_header) return {};
      return LinkPayload{half(packet, 0), packet.subspan(sll2_header),
                         wire::load_be<std::uint32_t>(packet, 4)};
    default: return {};
  }
}

}  // namespace drydock::capture
