#include "drivers/wire/j1939/j1939_transport.hpp"

#include <algorithm>

#include "drivers/wire/bytes.hpp"

namespace drydock::wire::j1939 {

namespace {

using Kind = TransportControl::Kind;
constexpr std::uint8_t transport_priority = 7;

void store_sizes(CanFrame& frame, const TransportControl& c) {
  store_le<std::uint16_t>(frame.data, 1, c.size);
  frame.data[3] = c.packets;
}

}  // namespace

std::optional<TransportControl> decode_transport_control(const Identifier& id, Bytes payload) {
  if (id.pgn != transport_control_pgn || payload.size() < 8) return std::nullopt;
  TransportControl c;
  c.kind = static_cast<Kind>(payload[0]);
  c.source = id.source;
  c.destination = id.destination;
  c.pgn = payload[5] | payload[6] << 8 | (payload[7] & 0x03) << 16;
  switch (c.kind) {
    case Kind::request_to_send: c.limit = payload[4]; [[fallthrough]];
    case Kind::end_of_message:
    case Kind::broadcast:
      c.size = load_le<std::uint16_t>(payload, 1);
      c.packets = payload[3];
      return c;
    case Kind::clear_to_send:
      c.packets = payload[1];
      c.next = payload[2];
      return c;
    case Kind::abort: c.reason = payload[1]; return c;
  }
  return std::nullopt;
}

CanFrame encode(const TransportControl& c) {
  CanFrame frame =
      blank_frame({transport_priority, transport_control_pgn, c.destination, c.source});
  frame.data[0] = static_cast<std::uint8_t>(c.kind);
  switch (c.kind) {
    case Kind::request_to_send: frame.data[4] = c.limit; [[fallthrough]];
    case Kind::end_of_message:
    case Kind::broadcast: store_sizes(frame, c); break;
    case Kind::clear_to_send:
      frame.data[1] = c.packets;
      frame.data[2] = c.next;
      break;
    case Kind::abort: frame.data[1] = c.reason; break;
  }
  for (unsigned i = 0; i < 3; ++i) frame.data[5 + i] = c.pgn >> 8 * i & 0xFF;
  return frame;
}

CanFrame encode_transport_packet(std::uint8_t source, std::uint8_t destination, Bytes message,
                                 unsigned number) {
  CanFrame frame = blank_frame({transport_priority, transport_data_pgn, destination, source});
  const Bytes rest = message.subspan((number - 1) * transport_packet_bytes);
  frame.data[0] = static_cast<std::uint8_t>(number);
  std::copy_n(rest.begin(), std::min(rest.size(), transport_packet_bytes), frame.data.begin() + 1);
  return frame;
}

}  // namespace drydock::wire::j1939
