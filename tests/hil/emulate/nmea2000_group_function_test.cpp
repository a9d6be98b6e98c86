#include <gmock/gmock.h>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "tests/hil/emulate/bench.hpp"

/// Heartbeats (PGN 126993) and group functions (PGN 126208) of an emulated speed log. Layouts and
/// error codes: canboat's database of PGNs (PGN_ERROR_CODE, TRANSMISSION_INTERVAL,
/// PARAMETER_FIELD).
namespace drydock::emulate {
namespace nmea2000_group_function_test {

namespace j1939 = wire::j1939;
using rig_config::DeviceKind;
using testing::ElementsAre;
using testing::IsEmpty;

using Data = std::vector<std::uint8_t>;

constexpr std::uint8_t log_address = 0x25, client = 100;
constexpr std::uint32_t group_function = 126208, heartbeat = 126993, product = 126996;

struct SpeedLog {
  SpeedLog() { sent.run(*node, at_s(1)); }

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
      const auto id = j1939::identify(frame).value();
      if (id.pgn != pgn) continue;
      const auto data = frame.payload();
      if (pgn == heartbeat)
        all.emplace_back(data.begin(), data.end());
      else if (const auto packet = assembler.receive(id, data))
        all.emplace_back(packet->data.begin(), packet->data.end());
    }
    return all;
  }
  std::vector<Data> answers() const { return sent_of(group_function); }

  Frozen trajectory{at_the_surface()};
  std::unique_ptr<EmulatedDevice> node =
      make_emulated_device(device(DeviceKind::emlog, "nmea2000", 0.01), trajectory, 1).value();
  Recorder sent;
  std::uint8_t told = 0;
};

/// A request without parameters: interval in ms, offset unchanged.
Data request(std::uint32_t pgn, std::uint32_t interval_ms) {
  Data message(11, 0xFF);
  message[0] = 0;
  wire::store_le<std::uint32_t>(message, 1, pgn);
  wire::store_le<std::uint32_t>(message, 4, interval_ms);
  message[10] = 0;
  return message;
}
constexpr std::uint32_t unchanged = 0xFFFFFFFF, default_interval = 0xFFFFFFFE;

/// 60,000 ms is EA60h; the counter goes from 0 to 252.
TEST(Nmea2000GroupFunction, AHeartbeatComesEachMinuteWithItsCounter) {
  SpeedLog log;
  log.sent.run(*log.node, at_s(181));
  const auto beats = log.sent_of(heartbeat);
  ASSERT_EQ(beats.size(), 3u);
  for (std::size_t i = 0; i < beats.size(); ++i)
    EXPECT_THAT(beats[i], ElementsAre(0x60, 0xEA, i, 0xCC, 0xFF, 0xFF, 0xFF, 0xFF));
}

TEST(Nmea2000GroupFunction, TheIntervalOfTheHeartbeatIsObeyedFromOneToSixtySeconds) {
  SpeedLog log;
  log.tell(request(heartbeat, 1000));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x11, 0xF0, 0x01, 0x00, 0)));
  log.sent.frames.clear();
  log.sent.run(*log.node, at_s(301.5));
  const auto beats = log.sent_of(heartbeat);
  ASSERT_EQ(beats.size(), 300u);
  EXPECT_EQ(wire::load_le<std::uint16_t>(beats[0], 0), 1000);
  EXPECT_EQ((beats[299][2] - beats[0][2] + 253) % 253, 299 % 253) << "252 is followed by 0";

  log.tell(request(heartbeat, 999));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x11, 0xF0, 0x01, 0x20, 0))) << "too low";
  log.tell(request(heartbeat, 60001));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x11, 0xF0, 0x01, 0x10, 0)));
  log.tell(request(heartbeat, default_interval));
  log.sent.frames.clear();
  log.sent.run(*log.node, at_s(361));
  EXPECT_THAT(log.sent_of(heartbeat), IsEmpty());
}

TEST(Nmea2000GroupFunction, ARequestBringsThePgnToAllToo) {
  SpeedLog log;
  for (const std::uint8_t destination : {log_address, j1939::global_address}) {
    log.tell(request(product, unchanged), destination);
    EXPECT_EQ(log.sent_of(product).size(), 1u);
    EXPECT_THAT(log.answers(), IsEmpty());
    log.tell(request(heartbeat, unchanged), destination);
    EXPECT_EQ(log.sent_of(heartbeat).size(), 1u);
  }
  log.tell(request(product, unchanged), 0x55);
  EXPECT_THAT(log.sent.frames, IsEmpty()) << "asked of another node";
}

/// 126720 is 1EF00h, 128259 is 1F503h, 126996 is 1F014h.
TEST(Nmea2000GroupFunction, WhatItCannotDoIsRefusedWithItsCode) {
  SpeedLog log;
  log.tell(request(126720, unchanged));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x00, 0xEF, 0x01, 0x01, 0)));
  log.tell(request(128259, 100));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x03, 0xF5, 0x01, 0x10, 0)));
  auto paired = request(product, unchanged);
  paired[10] = 3;
  paired.insert(paired.end(), {1, 0x34, 0x08, 2, 0, 0, 8, 1});
  log.tell(paired);
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x14, 0xF0, 0x01, 0x00, 3, 0x55, 0xF5)));
  log.tell({1, 0x14, 0xF0, 0x01, 0xF8, 1, 2, 0, 0});
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x14, 0xF0, 0x01, 0x04, 1, 0xF5)));
  log.tell({1, 0x00, 0xEF, 0x01, 0xF3, 1, 2, 0, 0});
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x00, 0xEF, 0x01, 0x11, 1, 0xF1)))
      << "PGN, priority 3 and parameter";
  log.tell({3, 0x14, 0xF0, 0x01, 1, 0, 1, 2});
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x14, 0xF0, 0x01, 0x06, 0)))
      << "read fields";
}

TEST(Nmea2000GroupFunction, AcknowledgementsShortOnesAndRefusalsToAllAreNotAnswered) {
  SpeedLog log;
  log.tell({2, 0x14, 0xF0, 0x01, 0, 0});
  EXPECT_THAT(log.sent.frames, IsEmpty());
  log.tell({0, 0x14, 0xF0});
  EXPECT_THAT(log.sent.frames, IsEmpty());
  log.tell({});
  EXPECT_THAT(log.sent.frames, IsEmpty());
  log.tell(request(126720, unchanged), j1939::global_address);
  EXPECT_THAT(log.sent.frames, IsEmpty());
}

}  // namespace nmea2000_group_function_test
}  // namespace drydock::emulate
