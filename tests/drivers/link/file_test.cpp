#include <gmock/gmock.h>

#include <fstream>

#include "drivers/link/file.hpp"
#include "tests/drivers/link/running.hpp"

namespace drydock::link::testing {
namespace {

class File : public ::testing::Test {
 protected:
  std::string recording(const Buffer& content) {
    const std::string path = folder.file("dive.cap");
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(content.data()),
               static_cast<std::streamsize>(content.size()));
    return "file:" + path;
  }

  Folder folder;
  asio::io_context io;
  Buffer buffer = Buffer(4096);
};

TEST_F(File, GivesEveryByteAndThenItsEnd) {
  Buffer content(256);
  for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<std::uint8_t>(i);
  const auto link = open(io, recording(content), Side::driver);
  EXPECT_EQ(run(io, read_bytes(*link, 10'000)).value(), content);
  EXPECT_EQ(run(io, link->read(buffer)).error(), asio::error::eof);
  EXPECT_EQ(link->provenance(), Provenance::replayed);
}

TEST_F(File, HearsNothingThatIsWrittenToIt) {
  const auto link = open(io, recording(bytes("abc")), Side::driver);
  EXPECT_TRUE(run(io, link->write(bytes("command"))));
  EXPECT_EQ(run(io, read_bytes(*link, 10)).value(), bytes("abc"));
}

TEST_F(File, TakesAsLongAsTheLineDid) {
  const auto link = open(io, recording(Buffer(384, 'x')) + "?baud=38400", Side::driver);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(run(io, read_bytes(*link, 384)).value().size(), 384U);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 100ms);  // 384 bytes of 10 bits at 38400
}

TEST_F(File, SpeedDividesThatTime) {
  const auto link = open(io, recording(Buffer(3840, 'x')) + "?baud=38400&speed=10", Side::driver);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(run(io, read_bytes(*link, 3840)).value().size(), 3840U);
  const auto took = std::chrono::steady_clock::now() - begin;
  EXPECT_GE(took, 100ms);
  EXPECT_LT(took, 900ms);
}

TEST_F(File, AMessageComesWhenItsDeviceSaysTimesTheSpeed) {
  const auto uri = parse_uri(recording(bytes("abcdefgh")) + "?speed=1000&clock=device").value();
  const auto link = open_file(io.get_executor(), uri, Side::driver, {{3, 100s}, {6, 160s}}).value();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(run(io, link->read(buffer)).value().size, 3U);
  EXPECT_EQ(run(io, link->read(buffer)).value().size, 3U);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 60ms);
  EXPECT_EQ(run(io, link->read(buffer)).value().size, 2U);  // behind the last message: at once
}

TEST_F(File, ClosingEndsAPacedRead) {
  const auto link = open(io, recording(bytes("abc")) + "?baud=50&speed=0.01", Side::driver);
  const auto pending = start(io, link->read(buffer));
  settle(io);
  link->close();
  ASSERT_TRUE(run_until(io, [&] { return pending->outcome.has_value(); }));
  EXPECT_EQ(pending->outcome->error(), asio::error::operation_aborted);
}

TEST_F(File, TheCommentsOfItsHeadAreNoBytesOfTheLine) {
  const Buffer content = bytes("# Name: gps\n# Date\nabc\n# d\n");
  const auto link = open(io, recording(content), Side::driver);
  EXPECT_EQ(run(io, read_bytes(*link, 100)).value(), bytes("abc\n# d\n"));
  const auto raw = open(io, recording(content) + "?format=raw", Side::driver);
  EXPECT_EQ(run(io, read_bytes(*raw, 100)).value(), content);
}

TEST_F(File, ALineThatADeviceBeginsWithAHashIsData) {
  const Buffer content = bytes("#BESTPOSA,COM1\n# d\n");
  const auto link = open(io, recording(content), Side::driver);
  EXPECT_EQ(run(io, read_bytes(*link, 100)).value(), content);
}

class FrameFile : public File {
 protected:
  std::unique_ptr<FrameLink> open_capture(const std::string& uri) {
    return open_frames(io.get_executor(), parse_uri(uri).value(), Side::driver).value();
  }
  std::vector<std::uint32_t> identifiers(FrameLink& link) {
    std::vector<std::uint32_t> ids;
    for (;;) {
      const auto frame = run(io, link.read());
      if (!frame) {
        EXPECT_EQ(frame.error(), asio::error::eof);
        return ids;
      }
      ids.push_back(frame->frame.id);
    }
  }
};

TEST_F(FrameFile, GivesTheFramesOfACaptureInAnyFormatAndThenItsEnd) {
  const std::string folder_of_captures = DRYDOCK_SOURCE_DIR "/fixtures/capture/";
  const std::vector<std::uint32_t> ids{0x123, 0x18EEFF01, 0x7FF, 0x09F80102,
                                       0,     0x80,       0x321, 0x12345678};
  for (const char* file : {"frames.log", "hex.asc", "v2.1.trc", "le.pcapng"}) {
    const auto link = open_capture("file:" + folder_of_captures + file);
    EXPECT_EQ(identifiers(*link), ids) << file;
    EXPECT_EQ(link->provenance(), Provenance::replayed);
  }
  const auto can1 = open_capture("file:" + folder_of_captures + "frames.log?interface=can1");
  EXPECT_EQ(identifiers(*can1), (std::vector<std::uint32_t>{0x7FF, 0x09F80102}));
}

TEST_F(FrameFile, KeepsTheCapturesTimes) {
  const std::string uri = recording(bytes("(9.00) can0 123#00\n(9.12) can0 124#00\n"));
  const auto took = [&](const std::string& speed) {
    const auto begin = std::chrono::steady_clock::now();
    const auto link = open_capture(uri + speed);
    EXPECT_EQ(identifiers(*link).size(), 2U);
    return std::chrono::steady_clock::now() - begin;
  };
  EXPECT_GE(took(""), 120ms);
  EXPECT_GE(took("?speed=2"), 60ms);
  EXPECT_LT(took("?speed=max"), 60ms);
}

TEST_F(FrameFile, OfNoKnownFormatIsToldTheFormatsThatAreKnown) {
  const auto link = open_frames(
      io.get_executor(), parse_uri(recording(bytes("$GPGGA,1*00\r\n"))).value(), Side::driver);
  ASSERT_FALSE(link);
  EXPECT_THAT(link.error().message,
              ::testing::HasSubstr(
                  "no CAN capture of a known format; known are: pcap, pcapng, blf, candump-log, "));
}

TEST_F(File, OpensOnlyRecordings) {
  const auto open_error = [&](const std::string& uri, Side side) {
    const auto link = open_bytes(io.get_executor(), parse_uri(uri).value(), side);
    return link ? std::string("opened") : link.error().message;
  };
  EXPECT_EQ(open_error("file:/nowhere.cap", Side::driver),
            "cannot open /nowhere.cap: No such file or directory");
  EXPECT_EQ(open_error("file:/dev/null", Side::driver), "/dev/null is no regular file");
  EXPECT_EQ(open_error("file:dive.cap", Side::device),
            "dive.cap is a recording: no emulated device can stand behind it");
}

}  // namespace
}  // namespace drydock::link::testing
