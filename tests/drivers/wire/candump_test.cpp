#include "drivers/wire/candump.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/drivers/wire/line_stream.hpp"

namespace drydock::wire {
namespace {

using candump::Direction;
using candump::Line;
using test::as_bytes;
using test::cut_stream;

std::optional<Line> parse(const std::string& line) {
  const auto message = Candump::decode(as_bytes(line));
  if (!message) return std::nullopt;
  return std::get<Line>(*message);
}

std::string print(const Line& line) {
  std::array<std::uint8_t, Candump::max_frame> out;
  return {out.begin(), out.begin() + candump::encode(line, out)};
}

TEST(Candump, ReadsTheLinesOfCanUtils) {
  const auto lines = test::lines_of(test::fixture("candump/canutils.log"));
  ASSERT_EQ(lines.size(), 8u);
  const std::string first = lines[0] + "\n";
  const auto line = parse(first).value();
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
  EXPECT_EQ(parse("(1.5) can0 123#00 T\n")->direction, Direction::transmitted);
  EXPECT_EQ(parse("(1.5) can0 123#00 R\r")->direction, Direction::received);
  EXPECT_EQ(parse("(1.5) can0 123#00\n")->time.count(), 1500000000);
  EXPECT_EQ(parse("(0.123456789) can0 123#00\n")->time.count(), 123456789);
}

TEST(Candump, RefusesWhatIsNoFrame) {
  for (const char* line :
       {"(1.5) can0 123#001\n", "(1.5) can0 800#00\n", "(1.5) can0 1234#00\n",
        "(1.5) can0 123#0G\n", "(1.5) can0 123#112233445566778899\n",
        "(1.5) can0 123##1112233445566778899\n", "(1.5) can0 80000123#00\n", "(x.5) can0 123#00\n",
        "(1) can0 123#00\n", "(1.5)can0 123#00\n", "(1.5) can0 123\n", "(1.5) can0 123#R9\n",
        "(1.5) can0 123##\n", "(99999999999.0) c 123#\n", "(1.5) can0 123#00",
        "(-1.5) can0 123#00\n", "(1.5) can0 123#11..22\n"}) {
    EXPECT_FALSE(parse(line)) << line;
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
      const std::string ended = line + "\n";
      if (const auto parsed = parse(ended)) {
        ++frames;
        ASSERT_EQ(print(*parsed), ended);
      } else {
        ASSERT_NE(line.substr(0, 2), "(1") << line;
      }
    }
    EXPECT_GE(frames, 20u) << path;
  }
}

TEST(Candump, PrintsFixturesBackByteForByte) {
  for (const std::string& line : test::lines_of(test::fixture("candump/canutils.log"))) {
    const std::string ended = line + "\n";
    EXPECT_EQ(print(parse(ended).value()), ended);
  }
}

TEST(Candump, ALineThatDoesNotFitIsNotWritten) {
  std::array<std::uint8_t, 20> small;
  EXPECT_EQ(candump::encode({{}, "can0", test::frame("123#00"), {}}, small), 0u);
}

TEST(Candump, FindsTheGoodLineGluedBehindATornOne) {
  const auto cut = cut_stream<Candump>({"(1795257228.4347(1.000000) can0 123#11\n"});
  ASSERT_EQ(cut.frames.size(), 1u);
  EXPECT_EQ(cut.frames[0], "(1.000000) can0 123#11\n");
  EXPECT_EQ(cut.counters.bad_checksums, 1u);
}

TEST(Candump, SkipsCommentsAndTakesEitherLineEnd) {
  const auto cut = cut_stream<Candump>(
      {"# a log (of a bus)\r\n(1.0) can0 123#11\r\n(2.0) can0 123#22\r(3.0) can0 123#33\n"});
  EXPECT_EQ(cut.frames.size(), 3u);
}

TEST(Candump, ALineWithoutEndIsGivenUpAtTheLongestFrame) {
  std::string endless = "(1.0) can0 123#";
  endless.append(400, '1');
  const auto cut = cut_stream<Candump>({endless, "\n(2.0) can0 123#22\n"});
  ASSERT_EQ(cut.frames.size(), 1u);
  EXPECT_EQ(cut.frames[0], "(2.0) can0 123#22\n");
}

std::string stream_with_noise() {
  const std::vector<std::string> parts{"(1.000000) can0 123#1122\n",
                                       "(2.000000) can1 18EEFF01#00\r",
                                       "(3.000000) can0 7FF##1001122334455667\n",
                                       "# comment\n",
                                       "(4.0",
                                       "((",
                                       "\n",
                                       "(5.0) can0 20000004#0004000000000000\n"};
  std::string text;
  for (const auto& part :
       *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(parts))) {
    text += part;
  }
  return text;
}

RC_GTEST_PROP(Candump, AnySplitGivesTheSameFrames, ()) {
  const std::string text = stream_with_noise();
  RC_ASSERT(cut_stream<Candump>(test::split_at_random(text)) == cut_stream<Candump>({text}));
}

RC_GTEST_PROP(Candump, AGoodLineSurvivesAnyNoiseBeforeIt, ()) {
  auto noise = *rc::gen::arbitrary<std::string>();
  const std::string good = "(1.000000) can0 123#1122\n";
  const auto cut = cut_stream<Candump>({noise + good});
  RC_ASSERT(!cut.frames.empty());
  RC_ASSERT(cut.frames.back() == good);
  RC_ASSERT(cut.counters.bytes_in ==
            cut.counters.bytes_good + cut.counters.bytes_skipped + cut.held);
}

}  // namespace
}  // namespace drydock::wire
