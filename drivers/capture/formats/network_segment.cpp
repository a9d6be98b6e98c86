#include "drivers/capture/formats/network_segment.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>

#include "drivers/wire/bytes.hpp"

namespace drydock::capture {
namespace {

using wire::Bytes;

constexpr std::uint8_t tcp = 6, udp = 17;

std::uint16_t half(Bytes bytes, std::size_t at) { return wire::load_be<std::uint16_t>(bytes, at); }

/// The part of an IP packet above its headers.
struct Transport {
  std::uint8_t protocol = 0;
  std::string sender, receiver;  ///< without their ports
  Bytes bytes;
};

std::string address_text(int family, Bytes address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  inet_ntop(family, address.data(), text.data(), text.size());
  return family == AF_INET6 ? "[" + std::string(text.data()) + "]" : text.data();
}

std::optional<Transport> of_ipv4(Bytes packet) {
  constexpr std::size_t least = 20;
  if (packet.size() < least || packet[0] >> 4 != 4) return {};
  const std::size_t header = (packet[0] & 0xFu) * 4, total = half(packet, 2);
  const bool is_later_fragment = (half(packet, 6) & 0x1FFF) != 0;
  if (header < least || packet.size() < header || is_later_fragment) return {};
  // A short packet is filled up on Ethernet. A length of 0 is one that the network card computes.
  if (total >= header) packet = packet.first(std::min(packet.size(), total));
  return Transport{packet[9], address_text(AF_INET, packet.subspan(12, 4)),
                   address_text(AF_INET, packet.subspan(16, 4)), packet.subspan(header)};
}

constexpr std::uint8_t ipv6_fragment = 44;

/// Extension headers with a length in units of 8 bytes (RFC 8200).
constexpr bool is_extension(std::uint8_t next) { return next == 0 || next == 43 || next == 60; }

std::optional<Transport> of_ipv6(Bytes packet) {
  constexpr std::size_t header = 40;
  if (packet.size() < header || packet[0] >> 4 != 6) return {};
  const std::size_t size = half(packet, 4);
  if (size > 0) packet = packet.first(std::min(packet.size(), header + size));
  std::uint8_t next = packet[6];
  Bytes rest = packet.subspan(header);
  while (is_extension(next)) {
    if (rest.size() < 8 || rest.size() < 8u + 8u * rest[1]) return {};
    next = rest[0];
    rest = rest.subspan(8u + 8u * rest[1]);
  }
  return Transport{next, address_text(AF_INET6, packet.subspan(8, 16)),
                   address_text(AF_INET6, packet.subspan(24, 16)), rest};
}

std::optional<NetworkSegment> segment_of(const Transport& transport) {
  constexpr std::size_t udp_header = 8, tcp_header = 20;
  constexpr std::uint8_t syn = 0x02;
  const Bytes bytes = transport.bytes;
  const bool stream = transport.protocol == tcp;
  if (!stream && transport.protocol != udp) return {};
  if (bytes.size() < (stream ? tcp_header : udp_header)) return {};
  NetworkSegment segment;
  segment.sender = transport.sender + ":" + std::to_string(half(bytes, 0));
  segment.receiver = transport.receiver + ":" + std::to_string(half(bytes, 2));
  segment.stream = stream;
  std::size_t header = udp_header;
  if (stream) {
    header = (bytes[12] >> 4) * std::size_t{4};
    segment.sequence = wire::load_be<std::uint32_t>(bytes, 4);
    segment.begins = (bytes[13] & syn) != 0;
  }
  if (header < (stream ? tcp_header : udp_header) || header > bytes.size()) return {};
  segment.payload = bytes.subspan(header);
  const std::size_t said = stream ? 0 : half(bytes, 4);
  if (said >= udp_header)
    segment.payload = segment.payload.first(std::min(segment.payload.size(), said - udp_header));
  return segment;
}

}  // namespace

std::string ipv4_address(Bytes address) { return address_text(AF_INET, address); }

std::string sender_of_fragment(const LinkPayload& packet) {
  constexpr std::size_t ipv6_header = 40;
  const Bytes bytes = packet.bytes;
  if (packet.protocol == protocol_ipv6 && bytes.size() >= ipv6_header && bytes[6] == ipv6_fragment)
    return address_text(AF_INET6, bytes.subspan(8, 16));
  return "";
}

std::optional<NetworkSegment> network_segment(const LinkPayload& packet) {
  std::optional<Transport> transport;
  if (packet.protocol == protocol_ipv4) transport = of_ipv4(packet.bytes);
  if (packet.protocol == protocol_ipv6) transport = of_ipv6(packet.bytes);
  return transport ? segment_of(*transport) : std::nullopt;
}

}  // namespace drydock::capture
