#pragma once

#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "hil/emulate/can/j1939_device.hpp"

namespace drydock::emulate {

/// The value of a NAME of the industry group "marine".
inline std::uint64_t marine_name(const DeviceConfig& config, std::uint8_t function,
                                 std::uint8_t device_class) {
  auto name = name_for(config, function, device_class);
  name.industry_group = 4;
  return to_value(name);
}

/// Sends a message of up to 223 bytes as the frames of a fast packet.
inline void send_packet(const wire::j1939::Identifier& id, std::uint8_t sequence,
                        wire::Bytes message, Wire& out) {
  for (std::size_t i = 0; i < wire::fast_packet_frames(message.size()); ++i)
    out.send(wire::encode_fast_packet(id, sequence, message, i));
}

template <wire::nmea2000::LaidOut M>
void send_packet(const M& message, std::uint8_t sequence, Wire& out) {
  std::array<std::uint8_t, M::bytes> bytes;
  wire::nmea2000::encode_payload(message, std::span{bytes});
  send_packet(wire::nmea2000::identifier_of(message), sequence, bytes, out);
}

}  // namespace drydock::emulate
