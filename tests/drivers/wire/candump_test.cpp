#include "drivers/wire/can/candump.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire {
namespace candump_test {

using candump::Direction;
using candump::Line;

using candump::parse_line;

std::string print(const Line& line) {
  std::array<std::uint8_t, candump::longest_line> out;
  return {out.begin(), out.begin() + candump::encode(line, out)};
}

TEST(Candump, ReadsTheLinesOfCanUtils) {
  const auto lines = test::lines_of(test::fixture("candump/canutils.log"));
  ASSERT_EQ(lines.size(), 8u);
  const auto line = parse_line(lines[0]).value();
  EXPECT_EQ(line.time, std::chrono::nanoseconds{1436509052249713000});
  EXPECT_EQ(line.interface, "vcan0");
  EXPECT_EQ(line.frame.id, 0x44u);
  EXPECT_FALSE(line.frame.extended);
  EXPECT_EQ(std::vector<std::uint8_t>(line.frame.data.begin(), line.frame.data.begin() + 5),
            (std::vector<std::uint8_t>{0x2A, 0x36, 0x6C, 0x2B, 0xBA}));
  EXPECT_EQ(line.frame.size, 5);
}

TEST(Candump, TellsFrameKindsApart) {
  const auto kinds = [](const std::string& text) { return test::frame(text); };
  EXPECT_TRUE(kinds("18EEFF01#05A0").extended);
  EXPECT_TRUE(kinds("00000123#05A0").extended);
  EXPECT_TRUE(kinds("7FF#R4").remote);
  EXPECT_EQ(kinds("7FF#R4").size, 4);
  EXPECT_EQ(kinds("12345678#R").size, 0);
  const CanFrame error = kinds("20000080#0000000000000000");
  EXPECT_TRUE(error.error);
  EXPECT_EQ(error.id, 0x80u);
  const CanFrame fd = kinds("7FF##5112233445566778899AABBCC");
  EXPECT_TRUE(fd.fd && fd.bit_rate_switch);
  EXPECT_EQ(fd.size, 12);
  EXPECT_EQ(kinds("123#11.22.33").size, 3);
  EXPECT_EQ(kinds("123#1122334455667788_F").size, 8);
}

TEST(Candump, KeepsTheDirectionAndAnyNumberOfDecimals) {
  EXPECT_EQ(parse_line("(1.5) can0 123#00 T")->direction, Direction::transmitted);
  EXPECT_EQ(parse_line("(1.5) can0 123#00 R")->direction, Direction::received);
  EXPECT_EQ(parse_line("(1.5) can0 123#00")->time.count(), 1500000000);
  EXPECT_EQ(parse_line("(0.123456789) can0 123#00")->time.count(), 123456789);
}

TEST(Candump, RefusesWhatIsNoFrame) {
  for (const char* line :
       {"(1.5) can0 123#001", "(1.5) can0 800#00", "(1.5) can0 1234#00", "(1.5) can0 123#0G",
        "(1.5) can0 123#112233445566778899", "(1.5) can0 123##1112233445566778899",
        "(1.5) can0 80000123#00", "(x.5) can0 123#00", "(1) can0 123#00", "(1.5)can0 123#00",
        "(1.5) can0 123", "(1.5) can0 123#R9", "(1.5) can0 123##", "(99999999999.0) c 123#",
        "(-1.5) can0 123#00", "(1.5) can0 123#11..22"}) {
    EXPECT_FALSE(parse_line(line)) << line;
  }
}

TEST(Candump, PrintsALogBackByteForByte) {
  for (const char* path :
       {"n2k/gpsd/logfile_20140914_365495765_can.log", "can_imu/aceinna_mtlt_real.candump.log",
        "n2k/canboat/samples/candumpSample3.txt"}) {
    const auto lines = test::lines_of(test::corpus(path));
    if (lines.empty()) GTEST_SKIP() << "corpora absent: n2k, can_imu";
    std::size_t frames = 0;
    for (const std::string& line : lines) {
      if (const auto parsed = parse_line(line)) {
        ++frames;
        ASSERT_EQ(print(*parsed), line + "\n");
      } else {
        ASSERT_NE(line.substr(0, 2), "(1") << line;
      }
    }
    EXPECT_GE(frames, 20u) << path;
  }
}

TEST(Candump, PrintsFixturesBackByteForByte) {
  for (const std::string& line : test::lines_of(test::fixture("candump/canutils.log"))) {
    EXPECT_EQ(print(parse_line(line).value()), line + "\n");
  }
}

TEST(Candump, ALineThatDoesNotFitIsNotWritten) {
  std::array<std::uint8_t, 20> small;
  EXPECT_EQ(candump::encode({{}, "can0", test::frame("123#00"), {}}, small), 0u);
}

}  // namespace candump_test
}  // namespace drydock::wire
