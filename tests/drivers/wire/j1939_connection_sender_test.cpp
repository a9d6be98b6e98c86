#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/drivers/wire/j1939_transport.hpp"

/// The sending end of a connection, then both ends. The frames are written by hand from the layout
/// of canboat's PGN database (60416); the times are those of J1939-21.
namespace drydock::wire::j1939 {
namespace j1939_connection_sender_test {

using namespace transport_ends;

TEST(Connection, TheSenderSendsWhatItIsGranted) {
  Talker talker;
  EXPECT_EQ(text_of(*talker.said), request);
  talker.hear("1CEC0180#110201FFFFD8FE00", 10ms);
  EXPECT_EQ(talker.tick(10ms), "1CEB8001#0101020304050607");
  EXPECT_EQ(talker.tick(10ms), "1CEB8001#0208090A0B0C0D0E");
  EXPECT_EQ(talker.tick(10ms), "");
  talker.hear("1CEC0180#110302FFFFD8FE00", 20ms);  // the second packet again, and the rest
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
    // The last packet of a grant is not repeated: the time-out reports its loss.
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

}  // namespace j1939_connection_sender_test
}  // namespace drydock::wire::j1939
