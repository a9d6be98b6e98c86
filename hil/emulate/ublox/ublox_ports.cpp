#include "hil/emulate/ublox/ublox_ports.hpp"

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/ubx/ubx_put.hpp"
#include "hil/emulate/ublox/ublox_dialogue.hpp"

namespace drydock::emulate::ublox {

namespace ubx = wire::ubx;
using wire::store_le;

std::size_t encode_io(const PortTraffic& traffic, std::span<std::uint8_t> out) {
  constexpr std::size_t ports = 6, block = 20;
  const auto payload = ubx::payload_in(out, ports * block);
  if (payload.empty()) return 0;
  const auto ours = payload.subspan(uart1 * block, block);
  store_le<std::uint32_t>(ours, 0, traffic.bytes_in);
  store_le<std::uint32_t>(ours, 4, traffic.bytes_out);
  return ubx::wrap(out, mon_io, payload.size());
}

std::size_t encode_comms(const PortTraffic& traffic, std::span<std::uint8_t> out) {
  constexpr auto port_ids = std::to_array<std::uint16_t>({0, 0x0100, 0x0201, 0x0300, 0x0400});
  constexpr auto protocols = std::to_array<std::uint8_t>({0, 1, 5, 0xFF});  // UBX, NMEA, RTCM 3
  constexpr std::size_t head = 8, block = 40;
  const auto payload = ubx::payload_in(out, head + block * port_ids.size());
  if (payload.empty()) return 0;
  payload[1] = static_cast<std::uint8_t>(port_ids.size());
  std::ranges::copy(protocols, payload.begin() + 4);
  for (std::size_t i = 0; i < port_ids.size(); ++i)
    store_le<std::uint16_t>(payload, head + block * i, port_ids[i]);
  const auto ours = payload.subspan(head + block * uart1, block);
  store_le<std::uint32_t>(ours, 4, traffic.bytes_out);
  store_le<std::uint32_t>(ours, 12, traffic.bytes_in);
  constexpr std::uint8_t little_used = 1;  // percent of a buffer
  if (traffic.bytes_out > 0) ours[8] = ours[9] = little_used;
  if (traffic.bytes_in > 0) ours[16] = ours[17] = little_used;
  store_le<std::uint16_t>(ours, 20, traffic.ubx_in);
  store_le<std::uint16_t>(ours, 22, traffic.nmea_in);
  store_le<std::uint32_t>(ours, 36, traffic.bytes_skipped);
  return ubx::wrap(out, mon_comms, payload.size());
}

Verdict UbloxDialogue::on_io(wire::Bytes) {
  send(wire::Bytes{bytes_}.first(encode_io(traffic_, bytes_)));
  return Verdict::none;
}

Verdict UbloxDialogue::on_comms(wire::Bytes) {
  traffic_.bytes_skipped = static_cast<std::uint32_t>(counters().bytes_skipped);
  send(wire::Bytes{bytes_}.first(encode_comms(traffic_, bytes_)));
  return Verdict::none;
}

}  // namespace drydock::emulate::ublox
