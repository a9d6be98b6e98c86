#pragma once

#include <gtest/gtest.h>

#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "drivers/wire/j1939/j1939_transport_receiver.hpp"
#include "drivers/wire/j1939/j1939_transport_sender.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

/// The two ends of J1939-21's transport, and the messages between them.
namespace drydock::wire::j1939::transport_ends {

using namespace std::chrono_literals;
using Time = TransportReceiver::Time;
using test::frame;
using test::text_of;

using Data = std::vector<std::uint8_t>;

struct Heard {
  Identifier id;
  Data data;
};

/// A receiver, the messages that it assembled, and the frames that it sent.
struct Listener {
  TransportReceiver receiver;
  std::vector<Heard> messages;
  std::vector<std::string> said;

  void hear(const CanFrame& f, Time now = 0ms) {
    auto got = receiver.receive(*identify(f), f.payload(), now);
    if (got.message) {
      messages.push_back({got.message->id, {got.message->data.begin(), got.message->data.end()}});
    }
    if (got.reply) said.push_back(text_of(*got.reply));
  }
  void hear(const char* text, Time now = 0ms) { hear(frame(text), now); }
  void wait_until(Time now) {
    while (receiver.deadline() && *receiver.deadline() <= now) {
      if (const auto f = receiver.tick(now)) said.push_back(text_of(*f));
    }
  }
};

inline Data counting(std::size_t size) {
  Data data(size);
  std::iota(data.begin(), data.end(), std::uint8_t{1});
  return data;
}

/// The frames of a broadcast of `data` by `source`.
inline std::vector<CanFrame> broadcast(std::uint8_t source, std::uint32_t pgn, const Data& data) {
  TransportSender sender;
  std::vector<CanFrame> frames{*sender.send({6, pgn, global_address, source}, data, 0ms)};
  while (sender.deadline()) frames.push_back(*sender.tick(*sender.deadline()));
  return frames;
}

/// A connection: node 1 sends 23 bytes (4 packets) of PGN 65240 to node 128.
inline constexpr const char* request = "1CEC8001#10170004FFD8FE00";

/// The sending end, with the frames of a receiver at 128.
struct Talker {
  TransportSender sender;
  std::optional<CanFrame> said;
  Talker() {
    const Data data = counting(23);
    said = sender.send({6, 65240, 0x80, 1}, data, 0ms);
  }
  void hear(const char* text, Time now) {
    const CanFrame f = frame(text);
    said = sender.receive(*identify(f), f.payload(), now);
  }
  std::string tick(Time now) {
    const auto f = sender.tick(now);
    return f ? text_of(*f) : "";
  }
};

}  // namespace drydock::wire::j1939::transport_ends
