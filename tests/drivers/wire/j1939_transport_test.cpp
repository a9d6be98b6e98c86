#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "drivers/wire/j1939_transport_receiver.hpp"
#include "drivers/wire/j1939_transport_sender.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

/// Frames written out by the layouts of canboat's PGN database (60416, 60160); times of J1939-21.
namespace drydock::wire::j1939 {
namespace j1939_transport_test {

using namespace std::chrono_literals;
using Time = TransportReceiver::Time;
using test::frame;
using test::text_of;

using Data = std::vector<std::uint8_t>;

struct Heard {
  Identifier id;
  Data data;
};

/// A receiver, what it put together and what it said.
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

Data counting(std::size_t size) {
  Data data(size);
  std::iota(data.begin(), data.end(), std::uint8_t{1});
  return data;
}

/// The frames of a broadcast of `data` by `source`.
std::vector<CanFrame> broadcast(std::uint8_t source, std::uint32_t pgn, const Data& data) {
  TransportSender sender;
  std::vector<CanFrame> frames{*sender.send({6, pgn, global_address, source}, data, 0ms)};
  while (sender.deadline()) frames.push_back(*sender.tick(*sender.deadline()));
  return frames;
}

TEST(Transport, PutsTheBroadcastsOfCanboatsTestsTogether) {
  Listener ear;
  for (const auto& f : test::frames_of_log(test::fixture("j1939-transport/broadcasts.log"))) {
    ear.hear(f);
  }
  ASSERT_EQ(ear.messages.size(), 2U);
  const auto& satellites = ear.messages[0];
  EXPECT_EQ(satellites.id.pgn, 129540U);
  EXPECT_EQ(satellites.id.source, 23);
  ASSERT_EQ(satellites.data.size(), 219U);
  const Data numbers{8, 9, 14, 66, 1, 2, 19, 22, 17, 4, 78, 3, 6, 65, 88, 72, 79, 81};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(satellites.data[3 + 12 * i], numbers[i]);
  }
  EXPECT_EQ(ear.messages[1].id.pgn, 130885U);
  EXPECT_EQ(ear.messages[1].data,
            (Data{0xA1, 0xA2, 0xA3, 0xA4, 0xA5, 0xA6, 0xA7, 0xA8, 0xA9, 0xAA, 0xAB, 0xAC}));
  EXPECT_TRUE(ear.said.empty());
}

TEST(Transport, BroadcastsTheFramesThatCanboatReads) {
  const Data data{0xA1, 0xA2, 0xA3, 0xA4, 0xA5, 0xA6, 0xA7, 0xA8, 0xA9, 0xAA, 0xAB, 0xAC};
  const auto frames = broadcast(0x21, 130885, data);
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(text_of(frames[0]), "1CECFF21#200C0002FF45FF01");
  EXPECT_EQ(text_of(frames[1]), "1CEBFF21#01A1A2A3A4A5A6A7");
  EXPECT_EQ(text_of(frames[2]), "1CEBFF21#02A8A9AAABACFFFF");
}

TEST(Transport, PacketsOfABroadcastAre50MsApart) {
  TransportSender sender;
  ASSERT_TRUE(sender.send({6, 130885, global_address, 0x21}, counting(20), 1s));
  EXPECT_EQ(sender.deadline(), 1050ms);
  EXPECT_FALSE(sender.tick(1049ms));
  EXPECT_TRUE(sender.tick(1050ms));
  EXPECT_EQ(sender.deadline(), 1100ms);
  EXPECT_TRUE(sender.busy());
  EXPECT_FALSE(sender.send({6, 130885, global_address, 0x21}, counting(20), 1060ms));
}

TEST(Transport, CarriesNineTo1785BytesAndNoOthers) {
  for (const std::size_t size : {std::size_t{9}, std::size_t{14}, std::size_t{1785}}) {
    Listener ear;
    for (const auto& f : broadcast(1, 65240, counting(size))) ear.hear(f);
    ASSERT_EQ(ear.messages.size(), 1U) << size;
    EXPECT_EQ(ear.messages[0].data, counting(size));
  }
  TransportSender sender;
  EXPECT_FALSE(sender.send({6, 65240, global_address, 1}, counting(8), 0ms));
  EXPECT_FALSE(sender.send({6, 65240, global_address, 1}, counting(1786), 0ms));
  EXPECT_FALSE(sender.busy());
}

TEST(Transport, ABroadcastWithALostPacketIsDroppedAndTheNextIsWhole) {
  Listener ear;
  const auto frames = broadcast(1, 65240, counting(21));
  ear.hear(frames[0]);
  ear.hear(frames[1]);
  ear.hear(frames[3]);
  EXPECT_EQ(ear.receiver.counters().dropped, 1U);
  for (const auto& f : frames) ear.hear(f);
  EXPECT_EQ(ear.messages.size(), 1U);
}

TEST(Transport, AnAnnouncementIsForgotten750MsAfterItsLastPacket) {
  Listener ear;
  const auto frames = broadcast(1, 65240, counting(21));
  ear.hear(frames[0], 1s);
  ear.hear(frames[1], 1200ms);
  EXPECT_EQ(ear.receiver.deadline(), 1950ms);
  ear.wait_until(1950ms);
  EXPECT_FALSE(ear.receiver.deadline());
  ear.hear(frames[2], 1960ms);
  ear.hear(frames[3], 1970ms);
  EXPECT_TRUE(ear.messages.empty());
  EXPECT_EQ(ear.receiver.counters().dropped, 1U);
  EXPECT_EQ(ear.receiver.counters().stray, 2U);
  EXPECT_TRUE(ear.said.empty());  // nobody is told of a broadcast lost
}

TEST(Transport, ANewAnnouncementIsNeverGluedOntoAStaleBody) {
  Listener ear;
  const auto old_frames = broadcast(1, 65240, Data(21, 0x11));
  const auto new_frames = broadcast(1, 65240, Data(21, 0x22));
  ear.hear(old_frames[0]);
  ear.hear(old_frames[1]);
  for (const auto& f : new_frames) ear.hear(f);
  ASSERT_EQ(ear.messages.size(), 1U);
  EXPECT_EQ(ear.messages[0].data, Data(21, 0x22));
}

RC_GTEST_PROP(Transport, InterleavedBroadcastsComeOutWhole, ()) {
  std::vector<std::vector<CanFrame>> queues;
  const auto talkers = *rc::gen::inRange<std::uint8_t>(1, TransportReceiver::max_concurrent + 1);
  std::vector<Data> sent;
  for (std::uint8_t i = 0; i < talkers; ++i) {
    sent.push_back(*rc::gen::container<Data>(*rc::gen::inRange<std::size_t>(9, 80),
                                             rc::gen::arbitrary<std::uint8_t>()));
    queues.push_back(broadcast(i, 130000u + i, sent.back()));
  }
  Listener ear;
  while (!queues.empty()) {
    const auto turn = *rc::gen::inRange<std::size_t>(0, queues.size());
    ear.hear(queues[turn].front());
    queues[turn].erase(queues[turn].begin());
    if (queues[turn].empty()) queues.erase(queues.begin() + static_cast<std::ptrdiff_t>(turn));
  }
  RC_ASSERT(ear.messages.size() == talkers);
  for (const auto& m : ear.messages) RC_ASSERT(m.data == sent[m.id.source]);
}

// A connection: node 1 sends 23 bytes (4 packets) of PGN 65240 to node 128.
constexpr const char* request = "1CEC8001#10170004FFD8FE00";

TEST(Connection, IsAnsweredWithClearToSendAndEndOfMessage) {
  Listener ear;
  ear.receiver.set_address(0x80);
  ear.hear(request);
  ASSERT_EQ(ear.said.size(), 1U);
  EXPECT_EQ(ear.said[0], "1CEC0180#110401FFFFD8FE00");  // 4 packets from the first
  for (const char* packet : {"1CEB8001#0101020304050607", "1CEB8001#0208090A0B0C0D0E",
                             "1CEB8001#030F101112131415", "1CEB8001#041617FFFFFFFFFF"}) {
    ear.hear(packet);
  }
  ASSERT_EQ(ear.messages.size(), 1U);
  EXPECT_EQ(ear.messages[0].data, counting(23));
  ASSERT_EQ(ear.said.size(), 2U);
  EXPECT_EQ(ear.said[1], "1CEC0180#13170004FFD8FE00");
  EXPECT_FALSE(ear.receiver.deadline());
}

TEST(Connection, GrantsNoMoreThanTheSenderWillSendAtOnce) {
  Listener ear;
  ear.receiver.set_address(0x80);
  ear.hear("1CEC8001#1017000402D8FE00");
  ear.hear("1CEB8001#0101020304050607");
  ear.hear("1CEB8001#0208090A0B0C0D0E");
  ASSERT_EQ(ear.said.size(), 2U);
  EXPECT_EQ(ear.said[0], "1CEC0180#110201FFFFD8FE00");
  EXPECT_EQ(ear.said[1], "1CEC0180#110203FFFFD8FE00");
}

TEST(Connection, AsksForALostPacketAgainWhenTheGrantIsOver) {
  Listener ear;
  ear.receiver.set_address(0x80);
  ear.hear(request);
  ear.hear("1CEB8001#0101020304050607");
  ear.hear("1CEB8001#030F101112131415");
  EXPECT_EQ(ear.said.size(), 1U);  // an earlier word would break into the sending
  ear.hear("1CEB8001#041617FFFFFFFFFF");
  ASSERT_EQ(ear.said.size(), 2U);
  EXPECT_EQ(ear.said[1], "1CEC0180#110302FFFFD8FE00");
  for (const char* packet :
       {"1CEB8001#0208090A0B0C0D0E", "1CEB8001#030F101112131415", "1CEB8001#041617FFFFFFFFFF"}) {
    ear.hear(packet);
  }
  ASSERT_EQ(ear.messages.size(), 1U);
  EXPECT_EQ(ear.messages[0].data, counting(23));
}

TEST(Connection, EndsWithAnAbortAfterTwoRepeatsInVain) {
  Listener ear;
  ear.receiver.set_address(0x80);
  ear.hear(request);
  for (int i = 0; i < 3; ++i) ear.hear("1CEB8001#041617FFFFFFFFFF");
  ASSERT_EQ(ear.said.size(), 4U);
  EXPECT_EQ(ear.said[3], "1CEC0180#FF05FFFFFFD8FE00");
  EXPECT_FALSE(ear.receiver.deadline());
}

TEST(Connection, TheReceiverGivesUpAfterT2BeforeAndT1BetweenPackets) {
  Listener ear;
  ear.receiver.set_address(0x80);
  ear.hear(request, 1s);
  EXPECT_EQ(ear.receiver.deadline(), 2250ms);
  ear.hear("1CEB8001#0101020304050607", 2s);
  EXPECT_EQ(ear.receiver.deadline(), 2750ms);
  ear.wait_until(2750ms);
  ASSERT_EQ(ear.said.size(), 2U);
  EXPECT_EQ(ear.said[1], "1CEC0180#FF03FFFFFFD8FE00");
}

TEST(Connection, OneOfTheSameSenderForAnotherMessageIsRefused) {
  Listener ear;
  ear.receiver.set_address(0x80);
  ear.hear(request);
  ear.hear("1CEC8001#10170004FF45FF01");
  ASSERT_EQ(ear.said.size(), 2U);
  EXPECT_EQ(ear.said[1], "1CEC0180#FF01FFFFFF45FF01");
  for (int i = 1; i <= 4; ++i) ear.hear(encode_transport_packet(1, 0x80, counting(23), i));
  EXPECT_EQ(ear.messages.size(), 1U);  // the first goes on
}

TEST(Connection, OfTwoOthersIsPutTogetherWithoutAWord) {
  Listener ear;
  ear.receiver.set_address(0x90);
  ear.hear(request);
  ear.hear("1CEC0180#110401FFFFD8FE00");
  for (int i = 1; i <= 4; ++i) ear.hear(encode_transport_packet(1, 0x80, counting(23), i));
  EXPECT_EQ(ear.messages.size(), 1U);
  EXPECT_TRUE(ear.said.empty());
}

TEST(Connection, SoundnessOfTheRequestIsChecked) {
  Listener ear;
  ear.receiver.set_address(0x80);
  ear.hear("1CEC8001#10FA0600FFD8FE00");  // 1786 bytes
  ear.hear("1CEC8001#10170003FFD8FE00");  // 23 bytes in 3 packets
  ASSERT_EQ(ear.said.size(), 2U);
  EXPECT_EQ(ear.said[0], "1CEC0180#FF09FFFFFFD8FE00");
  EXPECT_EQ(ear.said[1], "1CEC0180#FF07FFFFFFD8FE00");
  ear.hear("1CECFF01#10170004FFD8FE00");  // a request to all
  ear.hear("1CEC8001#20170004FFD8FE00");  // a broadcast to one
  EXPECT_FALSE(ear.receiver.deadline());
}

/// The sending end against what a receiver at 128 says.
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

TEST(Connection, TheSenderSendsWhatItIsGranted) {
  Talker talker;
  EXPECT_EQ(text_of(*talker.said), request);
  talker.hear("1CEC0180#110201FFFFD8FE00", 10ms);
  EXPECT_EQ(talker.tick(10ms), "1CEB8001#0101020304050607");
  EXPECT_EQ(talker.tick(10ms), "1CEB8001#0208090A0B0C0D0E");
  EXPECT_EQ(talker.tick(10ms), "");
  talker.hear("1CEC0180#110302FFFFD8FE00", 20ms);  // the second again, and the rest
  EXPECT_EQ(talker.tick(20ms), "1CEB8001#0208090A0B0C0D0E");
  EXPECT_EQ(talker.tick(20ms), "1CEB8001#030F101112131415");
  EXPECT_EQ(talker.tick(20ms), "1CEB8001#041617FFFFFFFFFF");
  EXPECT_TRUE(talker.sender.busy());
  talker.hear("1CEC0180#13170004FFD8FE00", 30ms);
  EXPECT_FALSE(talker.sender.busy());
  EXPECT_EQ(talker.sender.outcome(), TransportSender::Outcome::sent);
}

TEST(Connection, TheSenderGivesUpAfterT3WithoutAndT4WithAHold) {
  Talker unanswered;
  EXPECT_EQ(unanswered.sender.deadline(), 1250ms);
  EXPECT_EQ(unanswered.tick(1250ms), "1CEC8001#FF03FFFFFFD8FE00");
  EXPECT_EQ(unanswered.sender.outcome(), TransportSender::Outcome::timed_out);
  Talker held;
  held.hear("1CEC0180#1100FFFFFFD8FE00", 100ms);
  EXPECT_EQ(held.sender.deadline(), 1150ms);
}

TEST(Connection, TheSenderStopsWhenItIsTold) {
  Talker talker;
  talker.hear("1CEC0180#110401FFFFD8FE00", 10ms);
  talker.hear("1CEC0180#FF02FFFFFFD8FE00", 10ms);
  EXPECT_FALSE(talker.sender.busy());
  EXPECT_EQ(talker.sender.outcome(), TransportSender::Outcome::aborted);
}

TEST(Connection, AGrantAmidTheSendingOrBeyondTheMessageIsAborted) {
  Talker amid;
  amid.hear("1CEC0180#110401FFFFD8FE00", 10ms);
  amid.tick(10ms);
  amid.hear("1CEC0180#110401FFFFD8FE00", 10ms);
  EXPECT_EQ(text_of(*amid.said), "1CEC8001#FF04FFFFFFD8FE00");
  Talker beyond;
  beyond.hear("1CEC0180#110402FFFFD8FE00", 10ms);
  EXPECT_EQ(text_of(*beyond.said), "1CEC8001#FF07FFFFFFD8FE00");
}

RC_GTEST_PROP(Connection, GetsAnyMessageAcrossABusThatLosesAPacket, ()) {
  const auto data = *rc::gen::container<Data>(*rc::gen::inRange<std::size_t>(9, 400),
                                              rc::gen::arbitrary<std::uint8_t>());
  const auto lost = *rc::gen::inRange<unsigned>(0, transport_packets(data.size()));
  TransportReceiver receiver;
  receiver.set_address(0x80);
  TransportSender sender;
  Data got;
  unsigned sent = 0;
  auto on_bus = sender.send({6, 65240, 0x80, 1}, data, 0ms);
  while (on_bus || sender.deadline() == Time{}) {
    if (!on_bus) on_bus = sender.tick(0ms);
    const auto id = *identify(*on_bus);
    const bool is_packet = id.pgn == transport_data_pgn;
    // The last packet of a grant is not repeated: the time-out tells of it.
    const bool drop = is_packet && sent++ == lost && sender.deadline() == Time{};
    if (drop) {
      on_bus.reset();
      continue;
    }
    auto result = receiver.receive(id, on_bus->payload(), 0ms);
    if (result.message) got.assign(result.message->data.begin(), result.message->data.end());
    on_bus = result.reply ? sender.receive(*identify(*result.reply), result.reply->payload(), 0ms)
                          : std::nullopt;
  }
  RC_ASSERT(got == data);
  RC_ASSERT(sender.outcome() == TransportSender::Outcome::sent);
}

}  // namespace j1939_transport_test
}  // namespace drydock::wire::j1939
