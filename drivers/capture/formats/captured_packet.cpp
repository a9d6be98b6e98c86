#include "drivers/capture/formats/captured_packet.hpp"

#include "drivers/capture/formats/link_header.hpp"
#include "drivers/capture/formats/socketcan_packet.hpp"

namespace drydock::capture {

bool may_hold_can(std::uint32_t link_type) {
  return link_type == linktype_can_socketcan || is_cooked_link(link_type);
}

Reading can_frame_of(const CapturedPacket& packet) {
  wire::Bytes bytes = packet.bytes;
  bool big_endian = true;
  if (packet.link_type != linktype_can_socketcan) {
    if (!is_cooked_link(packet.link_type)) return Reading::nothing();
    const auto payload = link_payload(packet.link_type, bytes);
    if (!payload) return Reading::damage();
    if (payload->protocol != protocol_can && payload->protocol != protocol_can_fd)
      return Reading::nothing();
    bytes = payload->bytes;
    // Cooked packets are as the kernel has them: the identifier is in the computer's byte order.
    big_endian = packet.big_endian;
  }
  const auto frame = parse_socketcan_packet(bytes, big_endian);
  if (!frame) return Reading::damage();
  return {Record{packet.time, packet.interface, *frame}, false};
}

}  // namespace drydock::capture
