#include <gmock/gmock.h>

#include "drivers/capture/comment_head.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "tests/drivers/capture/captures.hpp"

/// Rare lines of the formats, and the refusal of files.
namespace drydock::capture::testing {
namespace formats_test {

using std::chrono::nanoseconds;
using ::testing::ElementsAre;
using wire::testing::as_bytes;
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

TEST(PcapFile, APacketTooLargeForCanIsPassedOver) {
  const Buffer file = wire::testing::fixture("capture/le_us.pcap");
  Buffer head(24 + 16);
  std::copy_n(file.begin(), 24, head.begin());
  wire::store_le<std::uint32_t>(head, 24 + 8, 100'000);
  const Buffer rest(file.begin() + 24, file.end());
  const Outcome outcome = read_capture(head + Buffer(100'000, 'x') + rest);
  EXPECT_EQ(outcome.records.size(), 8u);
  EXPECT_THAT(outcome.where, ElementsAre(2));
}

TEST(PcapFile, WhatAnOldKernelLeftInTheFlagsMakesNoCanFd) {
  Buffer file = wire::testing::fixture("capture/le_us.pcap");
  file[24 + 16 + 5] = 0x2E;  // as in canboat's can0-1.pcap
  const auto records = read_capture(file).records;
  ASSERT_EQ(records.size(), 8u);
  EXPECT_FALSE(records[0].frame.fd);
}

TEST(PcapFile, OfEthernetIsNoCanCapture) {
  Buffer file = wire::testing::fixture("capture/le_us.pcap");
  wire::store_le<std::uint32_t>(file, 20, 1);
  EXPECT_TRUE(read_capture(file).unknown);
}

TEST(UnknownFile, IsToldTheFormatsThatAreKnown) {
  EXPECT_TRUE(read_capture("$GPGGA,123519,4807.038,N*42\r\n").unknown);
  EXPECT_TRUE(read_capture(Buffer(200'000, 0x7F)).unknown);
  EXPECT_TRUE(read_capture("").unknown);
  EXPECT_EQ(
      unknown_format_text("dive.log"),
      "dive.log: no CAN capture of a known format; known are: pcap, pcapng, blf, candump-log, "
      "candump-screen, asc, trc, canboat");
}

TEST(Recognition, WaitsForTheFirstWholeLine) {
  FrameCapture capture;
  capture.feed(as_bytes("# a comment\n(1.0) can0 12"));
  EXPECT_FALSE(capture.next());
  EXPECT_EQ(capture.format(), nullptr);
  EXPECT_FALSE(capture.unknown());
  capture.feed(as_bytes("3#00\n"));
  EXPECT_TRUE(capture.next());
  EXPECT_EQ(capture.format()->name, "candump-log");
}

TEST(Recognition, TheMagicCountsWhateverThePacketsBehindItLookLike) {
  Buffer file = wire::testing::fixture("capture/le_us.pcap");
  const Buffer line = as_bytes("\n7FF [0]\n");
  std::ranges::copy(line, file.begin() + 8);  // time zone and snap length; the reader ignores them
  const Buffer lines = file + line + line;
  for (std::size_t piece = 1; piece <= lines.size(); ++piece) {
    FrameCapture capture;
    std::size_t frames = 0;
    for (std::size_t at = 0; at < lines.size(); at += piece) {
      capture.feed(Bytes{lines}.subspan(at, std::min(piece, lines.size() - at)));
      while (capture.next()) ++frames;
    }
    ASSERT_NE(capture.format(), nullptr) << piece;
    EXPECT_EQ(capture.format()->name, "pcap") << piece;
    EXPECT_EQ(frames, 8u) << piece;
  }
}

TEST(CommentHeadOfAByteCapture, IsDroppedInAnySplitAndNothingElse) {
  const std::string file = "# Name: a receiver\n# Date: 2014\r\n\xB5\x62 # data\n# data too\n";
  for (std::size_t piece = 1; piece <= file.size(); ++piece) {
    CommentHead head;
    Buffer rest;
    for (std::size_t at = 0; at < file.size(); at += piece) {
      const Buffer block = as_bytes(std::string_view(file).substr(at, piece));
      const Bytes left = head.without(block);
      rest.insert(rest.end(), left.begin(), left.end());
    }
    EXPECT_EQ(rest, as_bytes("\xB5\x62 # data\n# data too\n")) << piece;
    EXPECT_EQ(head.size(), file.size() - rest.size()) << piece;
  }
}

TEST(CommentHeadOfAByteCapture, EndsAtALineThatADeviceBeginsWithAHash) {
  const std::string data = "#BESTPOSA,COM1\r\n# data\n";
  const std::string file = "#\n#\r\n# Date: 2014\n" + data;
  for (std::size_t piece = 1; piece <= file.size(); ++piece) {
    CommentHead head;
    Buffer rest;
    for (std::size_t at = 0; at < file.size(); at += piece) {
      const Buffer block = as_bytes(std::string_view(file).substr(at, piece));
      const Bytes left = head.without(block);
      rest.insert(rest.end(), left.begin(), left.end());
    }
    EXPECT_EQ(rest, as_bytes(data)) << piece;
  }
}

}  // namespace formats_test
}  // namespace drydock::capture::testing
