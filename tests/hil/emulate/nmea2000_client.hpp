#pragma once

#include <gmock/gmock.h>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "tests/hil/emulate/bench.hpp"

/// Another node that asks an emulated speed log by group functions (PGN 126208).
namespace drydock::emulate {

using Data = std::vector<std::uint8_t>;

inline constexpr std::uint8_t log_address = 0x25, client = 100;
inline constexpr std::uint32_t group_function = 126208, heartbeat = 126993, product = 126996,
                               configuration = 126998, name_pgn = 60928, speed = 128259;

/// A speed log of this rate, a second after its boot.
struct SpeedLog {
  explicit SpeedLog(double rate_hz = 0.01,
                    const PowerUp& power = {start, std::make_shared<Condition>()})
      : node(make_emulated_device(device(rig_config::DeviceKind::emlog, "nmea2000", rate_hz),
                                  trajectory, 1, power)
                 .value()) {
    sent.run(*node, at_s(1));
  }

  void tell(const Data& message, std::uint8_t destination = log_address) {
    sent.frames.clear();
    for (std::size_t i = 0; i < wire::fast_packet_frames(message.size()); ++i)
      node->receive(
          wire::encode_fast_packet({3, group_function, destination, client}, told % 8, message, i),
          sent.now, sent);
    ++told;
  }
  std::vector<Data> sent_of(std::uint32_t pgn) const {
    std::vector<Data> all;
    wire::FastPacketAssembler assembler;
    for (const auto& [at, frame] : sent.frames) {
      const auto id = wire::j1939::identify(frame).value();
      if (id.pgn != pgn) continue;
      const auto data = frame.payload();
      if (pgn == heartbeat || pgn == name_pgn)
        all.emplace_back(data.begin(), data.end());
      else if (const auto packet = assembler.receive(id, data))
        all.emplace_back(packet->data.begin(), packet->data.end());
    }
    return all;
  }
  std::vector<Data> answers() const { return sent_of(group_function); }

  Frozen trajectory{at_the_surface()};
  std::unique_ptr<EmulatedDevice> node;
  Recorder sent;
  std::uint8_t told = 0;
};

/// A request without parameters: interval in ms, offset unchanged.
inline Data request(std::uint32_t pgn, std::uint32_t interval_ms) {
  Data message(11, 0xFF);
  message[0] = 0;
  wire::store_le<std::uint32_t>(message, 1, pgn);
  wire::store_le<std::uint32_t>(message, 4, interval_ms);
  message[10] = 0;
  return message;
}
inline constexpr std::uint32_t unchanged = 0xFFFFFFFF, default_interval = 0xFFFFFFFE;

}  // namespace drydock::emulate
