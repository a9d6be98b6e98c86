#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "tests/drivers/capture/captures.hpp"

/// Rare lines of the text formats.
namespace drydock::capture::testing {
namespace formats_test {

using ::testing::ElementsAre;
using namespace std::chrono_literals;

Seen only(const std::string& text) {
  const Outcome outcome = read_capture(text);
  EXPECT_EQ(outcome.records.size(), 1u) << text;
  EXPECT_EQ(outcome.damaged, 0u) << text;
  return outcome.records.empty() ? Seen{} : outcome.records.front();
}

std::vector<int> data_of(const Seen& seen) {
  return {seen.frame.data.begin(), seen.frame.data.begin() + seen.frame.size};
}

TEST(CandumpLogFile, FindsTheGoodLineGluedBehindATornOneAndCountsTheDamage) {
  const Outcome outcome =
      read_capture("(1.0) can0 123#00\n(1795257228.4347(2.000000) can0 124#11\n");
  ASSERT_EQ(outcome.records.size(), 2u);
  EXPECT_EQ(outcome.records[1].frame.id, 0x124u);
  EXPECT_THAT(outcome.where, ElementsAre(2));
}

TEST(CandumpLogFile, ALineThatNeverEndsIsGivenUp) {
  const std::string endless(70'000, '1');
  const Outcome outcome = read_capture("(1.0) can0 123#00\n" + endless + "\n(2.0) can0 124#22\n");
  EXPECT_EQ(outcome.records.size(), 2u);
  EXPECT_EQ(outcome.damaged, 1u);
  EXPECT_EQ(outcome.bytes_skipped, 70'001u);
}

TEST(CandumpScreenFile, TimeAndFlagsMayBeMissing) {
  EXPECT_THAT(data_of(only("  can0  123   [3]  11 22 33\n")), ElementsAre(0x11, 0x22, 0x33));
  EXPECT_EQ(only(" (000.001500)  can0  123   [0] \n").time, 1500us);
  const Seen fast = only("  vcan1  TX B E  12345678  [01]  FF   '.'\n");
  EXPECT_TRUE(fast.frame.fd && fast.frame.bit_rate_switch && fast.frame.extended);
  EXPECT_EQ(fast.interface, "vcan1");
  EXPECT_FALSE(fast.time);
}

constexpr const char* asc_head = "base hex  timestamps absolute\n";

TEST(AscFile, LinesOfPythonCansTests) {
  const Seen remote = only(asc_head + std::string("  30.300981 CANFD   3 Tx     50005x             "
                                                  "                   0 1 5 0 140000 73 200050 "
                                                  "7a60 46500250 460a0250 20011736 20010205\n"));
  EXPECT_TRUE(remote.frame.remote && remote.frame.extended);
  EXPECT_EQ(remote.frame.id, 0x50005u);
  EXPECT_EQ(remote.frame.size, 5);
  EXPECT_EQ(remote.interface, "can2");
  const Seen named = only(
      asc_head +
      std::string(
          "   0.045746 CANFD   62 Rx        167x  VehicleOperatingModes            1 0 8  8 73 80 "
          "00 10 "
          "00 09 e3 00   102187  133   323000 e000fb6c 46500250 4b140250 20011736 2001040d\n"));
  EXPECT_TRUE(named.frame.fd && named.frame.bit_rate_switch && named.frame.extended);
  EXPECT_THAT(data_of(named), ElementsAre(0x73, 0x80, 0, 0x10, 0, 9, 0xE3, 0));
}

TEST(AscFile, StatisticsAndStatesAndTransportProtocolsAreNoFrames) {
  const Outcome outcome = read_capture(
      asc_head +
      std::string("internal events logged\n// version 9.0.0\n   0.000000 Start of measurement\n"
                  "   0.015991 CAN 1 Status:chip status error passive - TxErr: 132 RxErr: 0\n"
                  "   1.015991 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%\n"
                  "   3.297743 1  J1939TP FEE3p        6    0  0   -   Rx   d 3 A0 0F A6\n"
                  "End TriggerBlock\n"));
  EXPECT_TRUE(outcome.records.empty());
  EXPECT_EQ(outcome.damaged, 0u);
}

TEST(AscFile, TheDateOfItsHeadIsTheTimeOfItsStart) {
  const std::string line = "   1.500000 1  123x            Rx   d 1 68\n";
  const auto time = [&](const std::string& date) {
    return only("date " + date + "\n" + line).time;
  };
  EXPECT_EQ(time("Sat Sep 30 15:06:13.191 2017"), 1506783973191ms + 1500ms);  // date -u -d ... +%s
  EXPECT_EQ(time("Sam Sep 30 15:06:13.191 2017"), 1506783973191ms + 1500ms);
  EXPECT_EQ(time("Sat Sep 30 03:06:13.191 pm 2017"), 1506783973191ms + 1500ms);
  EXPECT_EQ(time("Mon Dez 1 12:00:00 am 2025"), 1764547200000ms + 1500ms);
  EXPECT_EQ(time("Mandag 1 desember"), 1500ms);
}

/// python-can writes the time of the conversion into the head, and that of the data into the block;
/// its own ASCReader gives 1700000000.0.
TEST(AscFile, ATriggerBlockBeforeTheDateOfItsHeadIsTheStart) {
  const auto time = [&](const std::string& head, const std::string& block) {
    return only(head + "base hex  timestamps absolute\nBegin Triggerblock " + block +
                "\n   1.500000 1  123x            Rx   d 1 68\n")
        .time;
  };
  const std::string head = "date Thu Nov 26 10:09:56.678 PM 2026\n";
  EXPECT_EQ(time(head, "Tue Nov 14 10:13:20.000 PM 2023"), 1700000000s + 1500ms);
  EXPECT_EQ(time("", "Tue Nov 14 10:13:20.000 PM 2023"), 1700000000s + 1500ms);
  const auto of_head = 1795730996678ms + 1500ms;
  EXPECT_EQ(time(head, "Thu Nov 26 10:10:06.000 PM 2026"), of_head) << "a trigger comes later";
  EXPECT_EQ(time(head, "Thu Nov 26 10:09:56 PM 2026"), of_head) << "rounded down to its second";
}

TEST(TrcFile, LinesOfCantoolsTestsForVersion12) {
  const Outcome outcome = read_capture(
      ";$FILEVERSION=1.2\n;$STARTTIME=39878.6772258947;\n"
      "1) 1059.900 1 Rx 0300 7 00 00 00 00 04 00 00\n"
      "5) 1346.834 1 Warng FFFFFFFF 4 00 00 00 04 BUSLIGHT\n"
      "6) 1349.222 1 Error 0008 4 00 19 08 08\n"
      "7) 1352.743 1 Rx 0100 3 RTR\n");
  ASSERT_EQ(outcome.records.size(), 3u);
  EXPECT_EQ(outcome.damaged, 0u);
  EXPECT_THAT(data_of(outcome.records[0]), ElementsAre(0, 0, 0, 0, 4, 0, 0));
  EXPECT_TRUE(outcome.records[1].frame.error);
  EXPECT_TRUE(outcome.records[2].frame.remote);
  EXPECT_EQ(outcome.records[2].frame.size, 3);
  EXPECT_EQ(outcome.records[2].time.value() - outcome.records[0].time.value(), 292843us);
}

TEST(TrcFile, AMessageLongerThanAFrameIsNone) {
  const Outcome outcome = read_capture(
      ";$FILEVERSION=1.3\n"
      "1) 1.000 1 Rx 10062123 - 9 D2 AF AA 88 18 80 01 02 03\n"
      "2) 2.000 1 Rx 0123 - 2 AA BB\n");
  ASSERT_EQ(outcome.records.size(), 1u);
  EXPECT_THAT(outcome.where, ElementsAre(2));
}

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

/// As editors on Windows and mail programs leave text files.
TEST(EveryTextFormat, TakesTheMarkOfUtf8AndBlanksAroundALine) {
  for (const std::string line :
       {"(1436509052.249713) vcan0 044#2A366C2BBA", "  vcan0  044   [5]  2A 36 6C 2B BA",
        "   0.249713 1  44              Rx   d 5 2A 36 6C 2B BA",
        "2022-09-28-11:36:59.668,5,130311,35,255,8,c5,c0,1c,6e,ff,7f,ff,ff"}) {
    const Outcome plain = read_capture(line + "\n" + line + "\n");
    const Outcome edited = read_capture("\xEF\xBB\xBF" + line + " \t\r\n \t" + line + "  ");
    ASSERT_EQ(plain.records.size(), 2U) << line;
    ASSERT_EQ(edited.records.size(), 2U) << line;
    EXPECT_THAT(edited.where, ElementsAre());
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(edited.records[i].frame, plain.records[i].frame) << line;
  }
}

TEST(AscFile, TheBaseCountsInAnyLetters) {
  const Seen seen = only("Base Dec  Timestamps Absolute\n 0.1 1 217056256x RX d 2 10 255\n");
  EXPECT_EQ(seen.frame.id, 217056256U);
  EXPECT_THAT(data_of(seen), ElementsAre(10, 255));
}

/// PEAK's description of version 2: the type RR is a remote request, which has no data.
TEST(TrcFile, ARemoteRequestOfVersion2HasALengthAndNoData) {
  const Seen seen = only(
      ";$FILEVERSION=2.1\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n"
      "  4  300.0 RR 1 0100 Rx - 3\n");
  EXPECT_TRUE(seen.frame.remote);
  EXPECT_EQ(seen.frame.size, 3);
}

TEST(CandumpFile, WordsMayHaveMoreThanOneBlankBetweenThem) {
  const Outcome outcome = read_capture("(1436509052.249713)  vcan0\t044#2A366C2BBA   T\n");
  ASSERT_EQ(outcome.records.size(), 1U);
  EXPECT_EQ(outcome.records[0].frame.id, 0x44U);
  EXPECT_EQ(outcome.records[0].frame.size, 5);
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

TEST(FilesWithTimesOfDay, GoOnOverMidnight) {
  const Outcome actisense = read_capture(
      "A235959.900 01FF6 0EE00 05A0BE1C00A0A0C0\nA000000.100 01FF6 0EE00 05A0BE1C00A0A0C0\n");
  const Outcome ydwg = read_capture(
      "23:59:59.900 R 18EEFF01 05 A0\n23:59:59.800 T 18EEFF01 05\n00:00:00.100 R 18EEFF01 05\n");
  ASSERT_EQ(actisense.records.size(), 2U);
  ASSERT_EQ(ydwg.records.size(), 3U);
  EXPECT_EQ(*actisense.records[1].time - *actisense.records[0].time, 200ms);
  EXPECT_EQ(ydwg.records[1].time, 24h - 200ms) << "a line out of its order";
  EXPECT_EQ(ydwg.records[2].time, 24h + 100ms);
}

/// A line of SavvyCAN's own making has a comma at its end, and microseconds since its start.
TEST(SavvyCanFile, TimesMayCountFromTheStart) {
  const Seen seen = only("185818721,00000545,false,Rx,1,4,00,04,7F,FF,\n");
  EXPECT_EQ(seen.time, 185'818'721us);
  EXPECT_EQ(seen.frame.id, 0x545U);
  EXPECT_EQ(seen.interface, "can1");
  EXPECT_THAT(data_of(seen), ElementsAre(0x00, 0x04, 0x7F, 0xFF));
}

/// RFC 4648, section 10: "foobar" in base64 is Zm9vYmFy, "fooba" Zm9vYmE=, "foob" Zm9vYg==.
TEST(PythonCanFile, DataAreInBase64) {
  EXPECT_THAT(data_of(only("1.5,0x1,0,0,0,6,Zm9vYmFy\n")),
              ElementsAre('f', 'o', 'o', 'b', 'a', 'r'));
  EXPECT_THAT(data_of(only("1.5,0x1,0,0,0,5,Zm9vYmE=\n")), ElementsAre('f', 'o', 'o', 'b', 'a'));
  EXPECT_THAT(data_of(only("1.5,0x1,0,0,0,4,Zm9vYg==\n")), ElementsAre('f', 'o', 'o', 'b'));
  const Outcome outcome =
      read_capture("1.5,0x1,0,0,0,4,Zm9vYg==\n1.5,0x1,0,0,0,5,Zm9vYg==\n1.5,0x1,0,0,0,3,Zm9*\n");
  EXPECT_EQ(outcome.records.size(), 1U);
  EXPECT_EQ(outcome.damaged, 2U);
}

}  // namespace formats_test
}  // namespace drydock::capture::testing
