#include "drivers/capture/formats/message_frames.hpp"

#include <algorithm>

#include "drivers/wire/nmea2000/fast_pgns.hpp"

namespace drydock::capture {

namespace {

constexpr std::size_t frame_bytes = 8;

}  // namespace

Reading MessageFrames::first(const N2kMessage& message, bool is_whole) {
  message_ = message;
  way_ = way_of(is_whole);
  given_ = 0;
  sequence_ = (sequence_ + 1) % 8;
  const bool too_long = way_ == Way::one_frame && message.size > frame_bytes;
  return {more(), too_long};
}

MessageFrames::Way MessageFrames::way_of(bool is_whole) const {
  const std::uint32_t pgn = message_.id.pgn;
  if (message_.size <= frame_bytes)
    return is_whole && wire::is_fast_pgn(pgn) ? Way::fast_packet : Way::one_frame;
  if (pgn < wire::first_pgn_of_nmea2000 || message_.size > wire::fast_packet_max_bytes)
    return Way::transport;
  return wire::is_single_pgn(pgn) ? Way::one_frame : Way::fast_packet;
}

std::optional<Record> MessageFrames::more() {
  if (given_ == frames()) return std::nullopt;
  return Record{message_.time, "can0", frame(given_++)};
}

std::size_t MessageFrames::frames() const {
  switch (way_) {
    case Way::one_frame: return 1;
    case Way::fast_packet: return wire::fast_packet_frames(message_.size);
    case Way::transport: return 1 + wire::j1939::transport_packets(message_.size);
  }
  return 0;
}

wire::CanFrame MessageFrames::frame(std::size_t number) const {
  namespace j1939 = wire::j1939;
  const j1939::Identifier& id = message_.id;
  const wire::Bytes data{message_.data.data(), message_.size};
  if (way_ == Way::fast_packet) return wire::encode_fast_packet(id, sequence_, data, number);
  if (way_ == Way::transport && number > 0)
    return j1939::encode_transport_packet(id.source, id.destination, data,
                                          static_cast<unsigned>(number));
  if (way_ == Way::transport) {
    j1939::TransportControl announced;
    const bool to_all = id.destination == j1939::global_address;
    announced.kind = to_all ? j1939::TransportControl::Kind::broadcast
                            : j1939::TransportControl::Kind::request_to_send;
    announced.source = id.source;
    announced.destination = id.destination;
    announced.pgn = id.pgn;
    announced.size = static_cast<std::uint16_t>(data.size());
    announced.packets = static_cast<std::uint8_t>(j1939::transport_packets(data.size()));
    return j1939::encode(announced);
  }
  wire::CanFrame frame;
  frame.id = j1939::make_identifier(id);
  frame.extended = true;
  frame.size = static_cast<std::uint8_t>(std::min(data.size(), frame_bytes));
  std::copy_n(data.begin(), frame.size, frame.data.begin());
  return frame;
}

}  // namespace drydock::capture
