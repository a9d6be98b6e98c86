#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/drivers/wire/j1939_transport.hpp"

/// The frames are written by hand from the layouts of canboat's PGN database (60416, 60160); the
/// times are those of J1939-21.
namespace drydock::wire::j1939 {
namespace j1939_broadcast_test {

using namespace transport_ends;

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

TEST(Transport, ABroadcastWithoutItsAnnouncementIsCountedOnce) {
  Listener ear;
  const auto frames = broadcast(1, 65240, counting(21));
  for (const auto& f : frames) ear.hear(f);
  for (std::size_t i = 1; i < frames.size(); ++i) ear.hear(frames[i]);
  for (const auto& f : frames) ear.hear(f);
  EXPECT_EQ(ear.messages.size(), 2U);
  EXPECT_EQ(ear.receiver.counters().headless, 1U);
  EXPECT_EQ(ear.receiver.counters().dropped, 0U);
}

TEST(Transport, ABroadcastThatWaitsForItsLastPacketIsUnfinished) {
  Listener ear;
  auto frames = broadcast(1, 65240, counting(21));
  frames.pop_back();
  for (const auto& f : frames) ear.hear(f);
  EXPECT_EQ(ear.receiver.unfinished(), 1U);
  EXPECT_EQ(ear.receiver.counters().headless, 0U);
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
  EXPECT_TRUE(ear.said.empty());  // a lost broadcast is not reported to anybody
}

TEST(Transport, AListenerWithoutTicksForgetsItTooAndTellsTheNextMessageFromIt) {
  Listener ear;
  const auto old_frames = broadcast(1, 65240, Data(14, 0x11));
  const auto new_frames = broadcast(1, 65240, Data(14, 0x22));
  ear.hear(old_frames[0], 1s);
  ear.hear(old_frames[1], 1050ms);
  ear.hear(new_frames[2], 3601s);
  EXPECT_TRUE(ear.messages.empty());
  EXPECT_EQ(ear.receiver.counters().dropped, 1U);
  for (std::size_t i = 0; i < new_frames.size(); ++i)
    ear.hear(new_frames[i], 3602s + 750ms * static_cast<int>(i));  // T1 of J1939-21
  ASSERT_EQ(ear.messages.size(), 1U);
  EXPECT_EQ(ear.messages[0].data, Data(14, 0x22));
}

TEST(Transport, APacketOfABroadcastThatIsHeardTwiceIsTakenOnce) {
  Listener ear;
  const auto frames = broadcast(1, 65240, counting(21));
  for (const auto& f : frames) {
    ear.hear(f);
    if (&f != &frames.front()) ear.hear(f);
  }
  ASSERT_EQ(ear.messages.size(), 1U);
  EXPECT_EQ(ear.messages[0].data, counting(21));
  EXPECT_EQ(ear.receiver.counters().dropped + ear.receiver.counters().headless, 0U);
}

TEST(Transport, ABroadcastWhosePacketsChangedPlacesIsLostOnce) {
  Listener ear;
  auto frames = broadcast(1, 65240, counting(28));
  std::swap(frames[2], frames[3]);
  for (const auto& f : frames) ear.hear(f);
  EXPECT_TRUE(ear.messages.empty());
  EXPECT_EQ(ear.receiver.counters().dropped + ear.receiver.counters().headless, 1U);
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

}  // namespace j1939_broadcast_test
}  // namespace drydock::wire::j1939
