#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "tests/drivers/capture/captures.hpp"

/// Lines that hold a message put together from frames become those frames again.
namespace drydock::capture::testing {
namespace whole_messages_test {

using ::testing::ElementsAre;
using namespace std::chrono_literals;

TEST(CanboatFile, AMessagePutTogetherBecomesItsFastPacketAgain) {
  const Outcome outcome = read_capture(
      "2011-04-25-06:25:03.603,3,129029,36,255,43,e6,f1,3a,80,9c,c6,0d,00,12,38,aa,49,eb,51,07,00,"
      "0c,44,95,fb,15,b8,00,40,e1,33,00,00,00,00,00,13,fc,09,5a,00,8c,00,ff,ff,ff,7f,00\n");
  ASSERT_EQ(outcome.records.size(), 7u);  // 6 bytes, then 7 each
  wire::FastPacketAssembler assembler;
  std::optional<wire::FastPacket> whole;
  for (const Seen& seen : outcome.records) {
    EXPECT_EQ(seen.time, 1303712703603ms);
    const auto id = wire::j1939::parse_identifier(seen.frame.id);
    EXPECT_EQ(id.pgn, 129029u);
    EXPECT_EQ(id.source, 36);
    whole = assembler.receive(id, seen.frame.payload());
  }
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->data.size(), 43u);
  EXPECT_EQ(whole->data[0], 0xE6);
  EXPECT_EQ(whole->data[42], 0x00);
}

// What `canboat convert --to plain` makes of a dump without times (canboatjs' test data), and a
// line of a Signal K server's raw log (its issue 1829).
TEST(CanboatFile, ALineMayHaveNoTimeOrTheMarkOfASignalKServer) {
  const Outcome timeless = read_capture(",7,60416,33,255,8,20,0c,00,02,ff,45,ff,01\n");
  ASSERT_EQ(timeless.records.size(), 1u);
  EXPECT_FALSE(timeless.records[0].time);
  EXPECT_EQ(wire::j1939::parse_identifier(timeless.records[0].frame.id).source, 33);
  const Outcome marked = read_capture(
      "1731371761281;A;2024-11-12T00:36:01.281Z,6,127508,2,255,8,00,f7,04,ff,7f,ff,ff,ff\n");
  ASSERT_EQ(marked.records.size(), 1u);
  EXPECT_EQ(marked.records[0].time, 1731371761281ms);
  EXPECT_EQ(wire::j1939::parse_identifier(marked.records[0].frame.id).pgn, 127508u);
}

/// Lines 7 and 20 of canboat's pgn-test.in, shortened; its pgn-test.out has the second as a list of
/// PGNs (7 bytes).
TEST(CanboatFile, BehindAnAssembledMessageAShortOneOfAFastPacketIsWholeToo) {
  const std::string whole = "2022-10-11T11:47:22Z,3,126464,127,255,7,01,04,ff,01,11,fb,01\n";
  const std::string assembled = "2022-10-11T11:47:21Z,6,126208,36,0,9,02,82,ff,00,10,02,00,01,02\n";
  EXPECT_EQ(read_capture(whole).records.size(), 1U);  // a frame, as far as the file tells
  const Outcome outcome = read_capture(assembled + whole);
  ASSERT_EQ(outcome.records.size(), 4U);
  wire::FastPacketAssembler assembler;
  EXPECT_FALSE(assembler.receive({3, 126464, 255, 127}, outcome.records[2].frame.payload()));
  const auto list = assembler.receive({3, 126464, 255, 127}, outcome.records[3].frame.payload());
  ASSERT_TRUE(list);
  EXPECT_EQ(std::vector(list->data.begin(), list->data.end()),
            (std::vector<std::uint8_t>{0x01, 0x04, 0xFF, 0x01, 0x11, 0xFB, 0x01}));
}

/// Lines of canboatjs' tests. A system time (126992) is one frame of 8 bytes.
TEST(LinesOfWholeMessages, OfAPgnThatIsOneFrameMoreThanEightBytesAreItsFirstEight) {
  for (const std::string line :
       {"2024-01-01-00:00:00.000,3,126992,2,255,12,77,6d,34,f5,e7,b8,e7,96,fc,f3,6d,5d\n",
        "!PDGY,126992,3,2,255,0.563,d2009e45b3b8821d\n",
        "A173321.107 02FF3 1F010 77D2009E45B3B8821D00\n"}) {
    const Outcome outcome = read_capture(line);
    ASSERT_EQ(outcome.records.size(), 1U) << line;
    EXPECT_EQ(outcome.records[0].frame.id, 0x0DF01002U) << line;
    EXPECT_EQ(outcome.records[0].frame.size, 8) << line;
    EXPECT_EQ(outcome.records[0].frame.data[0], 0x77) << line;  // SID 119
    EXPECT_EQ(outcome.damaged, 1U) << line << "what was left out is said";
    EXPECT_EQ(outcome.bytes_skipped, 0U) << line;
  }
}

/// J1939-81's commanded address (65240): the NAME of 8 bytes and the new address. J1939-21 has the
/// announcement: 20h, size, packets, FFh, PGN.
TEST(LinesOfWholeMessages, OfAPgnOfJ1939MoreThanEightBytesCameByItsTransportProtocol) {
  for (const std::string to : {"255", "36"}) {
    const Outcome outcome = read_capture("2024-01-01-00:00:00.000,6,65240,17," + to +
                                         ",9,01,02,03,04,05,06,07,08,2a\n");
    ASSERT_EQ(outcome.records.size(), 3U);
    EXPECT_EQ(outcome.damaged, 0U);
    const bool to_all = to == "255";
    EXPECT_EQ(outcome.records[0].frame.id, to_all ? 0x1CECFF11U : 0x1CEC2411U);
    EXPECT_THAT(data_of(outcome.records[0]),
                ElementsAre(to_all ? 0x20 : 0x10, 9, 0, 2, 0xFF, 0xD8, 0xFE, 0));
    EXPECT_THAT(data_of(outcome.records[1]), ElementsAre(1, 1, 2, 3, 4, 5, 6, 7));
    EXPECT_THAT(data_of(outcome.records[2]), ElementsAre(2, 8, 0x2A, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF));
  }
}

/// canboat's iso-tp-preassembled-test.in has a line of satellites (129540) with 1779 bytes.
TEST(LinesOfWholeMessages, MoreThanAFastPacketHoldsCameByTheTransportProtocol) {
  std::string line = "2026-07-04T00:00:00.000Z,6,129540,23,255,1779";
  for (int i = 0; i < 1779; ++i) line += fmt::format(",{:02x}", i % 251);
  const Outcome outcome = read_capture(line + "\n");
  ASSERT_EQ(outcome.records.size(), 1U + 255U);  // 1779 = 254 * 7 + 1
  EXPECT_THAT(data_of(outcome.records[0]),
              ElementsAre(0x20, 0xF3, 0x06, 255, 0xFF, 0x04, 0xFA, 0x01));
  EXPECT_EQ(outcome.records.back().frame.data[0], 255);
  EXPECT_EQ(outcome.records.back().frame.data[1], 1778 % 251);
}

/// A position of canboatjs' test/ikonvert.js: 47 bytes, without the = that would fill the last four
/// letters. 51h is its SID.
TEST(IkonvertFile, Base64MayComeWithoutItsPadding) {
  const std::string data = "UZ9FfR+bI/////////9//////////3//////////fwD8AIgTiBMAAAAAAQAAAAA";
  const std::string head = "!PDGY,129029,3,2,255,483.236,";
  const Outcome bare = read_capture(head + data + "\n");
  ASSERT_EQ(bare.records.size(), 7U);
  EXPECT_EQ(bare.records[0].frame.data[1], 47);
  EXPECT_EQ(bare.records[0].frame.data[2], 0x51);
  EXPECT_EQ(read_capture(head + data + "=\n"), bare);
  EXPECT_EQ(read_capture(head + data + "\n" + head + data + "AA\n").damaged, 1U)
      << "6 bits are no byte";
  EXPECT_EQ(read_capture(head + data + "\n!PDGY,127257,3,17,255,0.463,AP9/UgAh/v\n").damaged, 1U)
      << "cut inside a byte";
}

/// The fourth line of canboat's pgn-test-actisense.in: 29 bytes of PGN 130842 from node 9,
/// priority 7.
TEST(ActisenseFile, AMessageBecomesItsFastPacketAgain) {
  const Outcome outcome = read_capture(
      "A000057.063 09FF7 1FF1A 3F9F24000000FFFFFFFFEFFFFFFF009AFFFFFFADFFFFFF050000000000\n");
  ASSERT_EQ(outcome.records.size(), 5U);  // 6 bytes, then 7 each
  wire::FastPacketAssembler assembler;
  std::optional<wire::FastPacket> whole;
  for (const Seen& seen : outcome.records) {
    EXPECT_EQ(seen.time, 57'063ms);
    EXPECT_EQ(seen.frame.id, 0x1DFF1A09U);  // 7 << 26 | 1FF1Ah << 8 | 9
    whole = assembler.receive(wire::j1939::parse_identifier(seen.frame.id), seen.frame.payload());
  }
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->data.size(), 29U);
  EXPECT_EQ(whole->data[0], 0x3F);
  EXPECT_EQ(whole->data[23], 0x05);
}

TEST(ActisenseFile, AnAddressedMessageKeepsItsDestination) {
  const Seen seen = only("A173321.107 23306 0EA00 14F001\n");
  EXPECT_EQ(seen.frame.id, 0x18EA3023U);  // a request of node 23h to node 30h, priority 6
  EXPECT_THAT(data_of(seen), ElementsAre(0x14, 0xF0, 0x01));
}

}  // namespace whole_messages_test
}  // namespace drydock::capture::testing
