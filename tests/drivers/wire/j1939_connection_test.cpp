#include <gtest/gtest.h>

#include "tests/drivers/wire/j1939_transport.hpp"

/// The receiving end of a connection. The frames are written by hand from the layout of canboat's
/// PGN database (60416); the times are those of J1939-21.
namespace drydock::wire::j1939 {
namespace j1939_connection_test {

using namespace transport_ends;

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
  EXPECT_EQ(ear.said.size(), 1U);  // an earlier message would disturb the sending
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
  EXPECT_EQ(ear.messages.size(), 1U);  // the first session goes on
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

}  // namespace j1939_connection_test
}  // namespace drydock::wire::j1939
