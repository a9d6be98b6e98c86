#include <gmock/gmock.h>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "tests/hil/emulate/bench.hpp"

/// What a node of another maker asks of ours. Signal K's canboatjs asks each node that it hears for
/// PGN 60928, 126996, 126998 and 126464. Layouts: canboat's database of PGNs.
namespace drydock::emulate {
namespace nmea2000_requests_test {

namespace j1939 = wire::j1939;
using rig_config::DeviceKind;
using testing::Contains;
using testing::ElementsAre;

constexpr std::uint8_t asker = 100;

struct Message {
  j1939::Identifier id;
  std::vector<std::uint8_t> data;
};

struct Asked {
  explicit Asked(DeviceKind kind)
      : node(make_emulated_device(device(kind, "nmea2000", 0.01), trajectory, 1).value()) {
    sent.run(*node, at_s(1));
  }
  /// Answers, with fast packets put together.
  std::vector<Message> to(std::uint32_t pgn, std::uint8_t destination) {
    sent.frames.clear();
    node->receive(j1939::encode(j1939::Request{asker, destination, pgn}), sent.now, sent);
    std::vector<Message> all;
    wire::FastPacketAssembler assembler;
    for (const auto& [at, frame] : sent.frames) {
      const auto id = j1939::identify(frame).value();
      if (id.pgn == 59392 || id.pgn == 60928) {
        const auto data = frame.payload();
        all.push_back({id, {data.begin(), data.end()}});
      } else if (const auto packet = assembler.receive(id, frame.payload())) {
        all.push_back({packet->id, {packet->data.begin(), packet->data.end()}});
      }
    }
    return all;
  }

  Frozen trajectory{at_the_surface()};
  std::unique_ptr<EmulatedDevice> node;
  Recorder sent;
};

std::string text_at(const Message& message, std::size_t offset, std::size_t size) {
  std::string text(message.data.begin() + static_cast<std::ptrdiff_t>(offset),
                   message.data.begin() + static_cast<std::ptrdiff_t>(offset + size));
  return text.substr(0, text.find('\xFF'));
}

std::vector<std::uint32_t> pgns_of(const Message& message) {
  std::vector<std::uint32_t> all;
  for (std::size_t at = 1; at + 3 <= message.data.size(); at += 3)
    all.push_back(message.data[at] | message.data[at + 1] << 8 | message.data[at + 2] << 16);
  return all;
}

TEST(Nmea2000Requests, EachDeviceTellsItsProduct) {
  for (const auto& [kind, address, model] : std::vector<std::tuple<DeviceKind, int, std::string>>{
           {DeviceKind::gnss, 0x26, "GNSS receiver"},
           {DeviceKind::emlog, 0x25, "speed log"},
           {DeviceKind::depth, 0x23, "depth sensor"},
           {DeviceKind::attitude, 0x27, "attitude sensor"},
           {DeviceKind::actuator, 0x24, "actuators"}}) {
    SCOPED_TRACE(model);
    Asked asked(kind);
    for (const int destination : {address, 0xFF}) {
      const auto answers = asked.to(126996, static_cast<std::uint8_t>(destination));
      ASSERT_EQ(answers.size(), 1u);
      EXPECT_EQ(answers[0].id.pgn, 126996u);
      EXPECT_EQ(answers[0].id.source, address);
      ASSERT_EQ(answers[0].data.size(), 134u);
      EXPECT_EQ(wire::load_le<std::uint16_t>(answers[0].data, 0), 2100) << "NMEA 2000 2.1";
      EXPECT_EQ(text_at(answers[0], 4, 32), model);
      EXPECT_EQ(answers[0].data[133], 1) << "LEN, 50 mA";
    }
    EXPECT_TRUE(asked.to(126996, 0x55).empty()) << "asked of another node";
  }
}

TEST(Nmea2000Requests, TheListsOfPgnsHoldWhatItSendsAndTakes) {
  Asked asked(DeviceKind::actuator);
  const auto lists = asked.to(126464, 0x24);
  ASSERT_EQ(lists.size(), 2u);
  for (const auto& list : lists) EXPECT_EQ(list.id.destination, asker);
  EXPECT_EQ(lists[0].data[0], 0) << "transmitted";
  EXPECT_EQ(lists[1].data[0], 1) << "received";
  for (const std::uint32_t pgn : {60928U, 126464U, 126996U, 127245U, 127488U})
    EXPECT_THAT(pgns_of(lists[0]), Contains(pgn));
  for (const std::uint32_t pgn : {59904U, 60928U, 127245U, 127488U})
    EXPECT_THAT(pgns_of(lists[1]), Contains(pgn));
}

/// PGN 126998: three texts, each with its length and 1 for ASCII.
TEST(Nmea2000Requests, TheConfigurationHasThreeTexts) {
  Asked asked(DeviceKind::gnss);
  const auto answers = asked.to(126998, 0x26);
  ASSERT_EQ(answers.size(), 1u);
  std::size_t at = 0, texts = 0;
  for (; at < answers[0].data.size(); at += answers[0].data[at], ++texts) {
    ASSERT_GE(answers[0].data[at], 2);
    EXPECT_EQ(answers[0].data[at + 1], 1);
  }
  EXPECT_EQ(at, answers[0].data.size());
  EXPECT_EQ(texts, 3u);
}

/// PGN 59392: control 1 is NAK; the last three bytes are the PGN (126720 = 1EF00h).
TEST(Nmea2000Requests, ARequestToItsAddressForAnUnknownPgnIsRefused) {
  Asked asked(DeviceKind::emlog);
  const auto refusal = asked.to(126720, 0x25);
  ASSERT_EQ(refusal.size(), 1u);
  EXPECT_EQ(refusal[0].id.pgn, 59392u);
  EXPECT_EQ(refusal[0].id.destination, asker);
  EXPECT_THAT(refusal[0].data, ElementsAre(1, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0xEF, 0x01));
  EXPECT_TRUE(asked.to(126720, 0xFF).empty()) << "asked of all";
  EXPECT_TRUE(asked.to(128259, 0x25).empty()) << "comes in its time";
  EXPECT_EQ(asked.to(60928, 0x25).size(), 1u) << "the claim, once";
}

}  // namespace nmea2000_requests_test
}  // namespace drydock::emulate
