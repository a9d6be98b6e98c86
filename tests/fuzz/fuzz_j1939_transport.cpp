#include <algorithm>
#include <cstdlib>

#include "drivers/wire/j1939/j1939_transport_receiver.hpp"
#include "drivers/wire/j1939/j1939_transport_sender.hpp"

using namespace drydock::wire;

/// Every 11 bytes are a packet of the transport protocol: kind and node, length, 8 bytes of data,
/// time since the last packet. A node at address 1 receives them, and also sends.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t step = 11;
  static const std::array<std::uint8_t, 100> message{};
  j1939::TransportReceiver receiver;
  j1939::TransportSender sender;
  std::chrono::nanoseconds now{};
  receiver.set_address(1);
  sender.send({6, 65240, 2, 1}, message, now);
  for (; size >= step; data += step, size -= step) {
    now += std::chrono::milliseconds{10 * data[10]};
    const bool control = (data[0] & 1) != 0;
    const auto destination = static_cast<std::uint8_t>((data[0] & 2) != 0 ? 255 : 1);
    const j1939::Identifier id{7,
                               control ? j1939::transport_control_pgn : j1939::transport_data_pgn,
                               destination, static_cast<std::uint8_t>(data[0] >> 2 & 3)};
    const Bytes payload{data + 2, std::min<std::size_t>(data[1], 8)};
    const auto got = receiver.receive(id, payload, now);
    if (got.message && got.message->data.size() > j1939::transport_max_bytes) std::abort();
    sender.receive(id, payload, now);
    while (receiver.deadline() && *receiver.deadline() <= now) receiver.tick(now);
    while (sender.deadline() && *sender.deadline() <= now) sender.tick(now);
  }
  return 0;
}
