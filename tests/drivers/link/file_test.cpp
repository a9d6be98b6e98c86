#include <fstream>

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

TEST_F(File, ClosingEndsAPacedRead) {
  const auto link = open(io, recording(bytes("abc")) + "?baud=50&speed=0.01", Side::driver);
  const auto pending = start(io, link->read(buffer));
  settle(io);
  link->close();
  ASSERT_TRUE(run_until(io, [&] { return pending->outcome.has_value(); }));
  EXPECT_EQ(pending->outcome->error(), asio::error::operation_aborted);
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
