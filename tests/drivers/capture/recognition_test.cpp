#include <gmock/gmock.h>

#include "drivers/capture/comment_head.hpp"
#include "drivers/wire/bytes.hpp"
#include "tests/drivers/capture/captures.hpp"

/// Which format a file has, what is said of one that has none, and the comments in front of bytes.
namespace drydock::capture::testing {
namespace recognition_test {

using ::testing::ElementsAre;
using wire::testing::as_bytes;

TEST(UnknownFile, WhatMustBeUnpackedOrConvertedFirstIsSaid) {
  const auto said = [](std::string_view head) {
    FrameCapture capture;
    capture.feed({reinterpret_cast<const std::uint8_t*>(head.data()), head.size()});
    capture.finish();
    capture.next();
    return unknown_format_text("dive.log", capture);
  };
  EXPECT_EQ(said(std::string_view("\x1F\x8B\x08\0\0\0\0\0", 8)),
            "dive.log: it is compressed: unpack it first with gunzip -k");
  EXPECT_EQ(said(std::string_view("\xFF\xFE\x16\x04\x31\x04", 6)),
            "dive.log: it is text in UTF-16: convert it first with iconv -f UTF-16 -t UTF-8");
  EXPECT_THAT(
      said(std::string_view("\xD4\xC3\xB2\xA1\2\0\4\0\0\0\0\0\0\0\0\0\0\0\4\0\1\0\0\0", 24)),
      ::testing::HasSubstr("tcpdump -i can0"));  // of Ethernet
  EXPECT_THAT(said("hello\n"), ::testing::HasSubstr("no CAN capture of a known format"));
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
      unknown_format_text("dive.log", FrameCapture()),
      "dive.log: no CAN capture of a known format; known are: pcap, pcapng, blf, candump-log, "
      "candump-screen, asc, trc, canboat, actisense, ydwg, ikonvert, savvycan, python-can, "
      "busmaster, crtd, ixxat, kvaser");
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

/// What is left of a file without its head, read in pieces of this size; `head_size`: of the head.
Buffer without_head(std::string_view file, std::size_t piece, std::size_t& head_size) {
  CommentHead head;
  Buffer rest;
  for (std::size_t at = 0; at < file.size(); at += piece) {
    const Buffer block = as_bytes(file.substr(at, piece));
    const Bytes left = head.without(block);
    rest.insert(rest.end(), left.begin(), left.end());
  }
  head_size = head.size();
  return rest;
}

TEST(CommentHeadOfAByteCapture, IsDroppedInAnySplitAndNothingElse) {
  const std::string_view data = "\xB5\x62 # data\n# data too\n";
  const std::string file = "# Name: a receiver\n# Date: 2014\r\n" + std::string(data);
  for (std::size_t piece = 1; piece <= file.size(); ++piece) {
    std::size_t head_size = 0;
    EXPECT_EQ(without_head(file, piece, head_size), as_bytes(data)) << piece;
    EXPECT_EQ(head_size, file.size() - data.size()) << piece;
  }
}

TEST(CommentHeadOfAByteCapture, EndsAtNumbersThatADeviceSendsBehindAHash) {
  for (const std::string data :
       {"#  12.3456, 3.40012\n# text\n", "# -0.5 +1.25 7\r\n", "#\t12;3\n"}) {
    const std::string file = "# 120 seconds long\n# - 7 sentences\n# 2014-11-20\n# ...\n" + data;
    for (std::size_t piece = 1; piece <= file.size(); ++piece) {
      std::size_t head_size = 0;
      EXPECT_EQ(without_head(file, piece, head_size), as_bytes(data)) << piece;
      EXPECT_EQ(head_size, file.size() - data.size()) << piece;
    }
  }
}

TEST(CommentHeadOfAByteCapture, EndsAtALineThatADeviceBeginsWithAHash) {
  const std::string data = "#BESTPOSA,COM1\r\n# data\n";
  const std::string file = "#\n#\r\n# Date: 2014\n" + data;
  for (std::size_t piece = 1; piece <= file.size(); ++piece) {
    std::size_t head_size = 0;
    EXPECT_EQ(without_head(file, piece, head_size), as_bytes(data)) << piece;
  }
}

/// A file of a named format that somebody has packed is told in whatever pieces it comes. Found by
/// the fuzzer of captures: of one byte at a time it was read as frames.
TEST(UnknownFile, ThatIsPackedIsToldInPiecesTooWhereAFormatIsNamed) {
  for (const std::size_t piece : {1u, 2u, 100u}) {
    FrameCapture capture(find_format("candump-log"));
    const auto bytes = as_bytes("BZh91AY&SY\n(1.000) can0 123#00\n");
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      capture.feed(wire::Bytes(bytes).subspan(at, std::min(piece, bytes.size() - at)));
      EXPECT_FALSE(capture.next()) << piece;
    }
    EXPECT_EQ(capture.advice(), "it is compressed: unpack it first with bunzip2 -k") << piece;
  }
}

}  // namespace recognition_test
}  // namespace drydock::capture::testing
