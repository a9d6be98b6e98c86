#include "drivers/wire/can/slcan.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "drivers/wire/hex.hpp"
#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/drivers/wire/line_stream.hpp"

namespace drydock::wire {
namespace slcan_test {

using slcan::Answer;
using slcan::Command;
using slcan::Frame;
using slcan::Reply;
using test::as_bytes;
using test::cut_stream;

std::string unescape(std::string text) {
  for (const auto& [name, byte] : {std::pair{"\\r", '\r'}, std::pair{"\\a", '\a'}}) {
    if (const auto at = text.find(name); at != std::string::npos) text.replace(at, 2, 1, byte);
  }
  return text;
}

std::string encoded(const Slcan::Message& message) {
  std::array<std::uint8_t, Slcan::max_frame> out;
  const auto size = std::visit([&](const auto& m) { return slcan::encode(m, out); }, message);
  return {out.begin(), out.begin() + size};
}

/// Describes a message in the words of the fixture's second column.
std::string described(const Slcan::Message& message) {
  if (const auto* command = std::get_if<Command>(&message)) {
    return "command " + std::string{command->text};
  }
  if (const auto* reply = std::get_if<Reply>(&message)) {
    return "reply " + std::string{to_string(reply->answer)};
  }
  const auto& [frame, time] = std::get<Frame>(message);
  char text[64];
  std::snprintf(text, sizeof text, "%s %0*X %s ", frame.remote ? "remote" : "frame",
                frame.extended ? 8 : 3, frame.id, frame.extended ? "ext" : "std");
  std::string words = text;
  if (frame.remote) {
    words += std::to_string(frame.size);
  } else if (frame.size == 0) {
    words += "-";
  } else {
    words += HexText(frame.payload()).view();
  }
  if (time) {
    std::snprintf(text, sizeof text, " time %04X", *time);
    words += text;
  }
  return words;
}

TEST(Slcan, ReadsAndWritesTheManualsExamples) {
  const auto lines = test::lines_of(test::fixture("slcan/manual_examples.tsv"));
  ASSERT_EQ(lines.size(), 23u);
  for (const std::string& line : lines) {
    const auto tab = line.find('\t');
    const std::string bytes = unescape(line.substr(0, tab));
    ASSERT_EQ(Slcan::scan(as_bytes(bytes)), Scan::frame(bytes.size())) << line;
    const auto message = Slcan::decode(as_bytes(bytes));
    ASSERT_TRUE(message) << line;
    EXPECT_EQ(described(*message), line.substr(tab + 1));
    EXPECT_EQ(encoded(*message), bytes);
  }
}

TEST(Slcan, TakesRemoteFramesWithoutTheirLengthDigit) {
  for (const auto& [line, size, timed] :
       {std::tuple{"r123\r", 0, false}, std::tuple{"r1234\r", 4, false},
        std::tuple{"r1230A1B\r", 0, true}, std::tuple{"R1234567830A1B\r", 3, true}}) {
    const std::string text = line;
    const auto message = Slcan::decode(as_bytes(text));
    ASSERT_TRUE(message) << line;
    const auto& frame = std::get<Frame>(*message);
    EXPECT_TRUE(frame.frame.remote);
    EXPECT_EQ(frame.frame.size, size) << line;
    EXPECT_EQ(frame.time_ms.has_value(), timed) << line;
  }
}

/// The lines of adapters for CAN FD, as in the firmware of CANable 2.0: `d` `D` at one rate, `b`
/// `B` at two, and the length code of ISO 11898-1: 9 is 12 bytes, F is 64.
TEST(Slcan, TakesFramesOfCanFd) {
  const std::string full(128, '5');
  for (const auto& [line, id, size, switches] :
       {std::tuple{"d123211FF\r" + std::string(), 0x123U, 2, false},
        std::tuple{"b7FF9" + std::string(24, 'A') + "\r", 0x7FFU, 12, true},
        std::tuple{"D09F11201F" + full + "\r", 0x9F11201U, 64, false},
        std::tuple{"B1FFFFFFFF" + full + "0A1B\r", 0x1FFFFFFFU, 64, true}}) {
    ASSERT_EQ(Slcan::scan(as_bytes(line)), Scan::frame(line.size())) << line;
    const auto message = Slcan::decode(as_bytes(line));
    ASSERT_TRUE(message) << line;
    const auto& frame = std::get<Frame>(*message).frame;
    EXPECT_TRUE(frame.fd);
    EXPECT_EQ(frame.id, id);
    EXPECT_EQ(frame.extended, id > 0x7FFU);
    EXPECT_EQ(frame.size, size);
    EXPECT_EQ(frame.bit_rate_switch, switches);
  }
}

/// "e1b" is an adapter's report of a bit error, and its letters are hexadecimal digits.
TEST(Slcan, TheDataOfAFrameOfCanFdAreNeverTakenForAReport) {
  const std::string data = std::string(125, 'a') + "e1b";
  const auto cut = cut_stream<Slcan>({"d123F" + data + "\rt1231AA\r"});
  EXPECT_EQ(cut.frames, (std::vector<std::string>{"d123F" + data + "\r", "t1231AA\r"}));
}

TEST(Slcan, RefusesWhatIsNoLine) {
  for (const char* line :
       {"t12\r", "t1239\r", "t800000\r", "t12321\r", "t1232112\r", "T200000000\r", "S9\r", "Z2\r",
        "Q\r", "O1\r", "t123211223\r", "t1231GG\r"}) {
    const std::string text = line;
    EXPECT_FALSE(Slcan::decode(as_bytes(text))) << line;
    EXPECT_EQ(Slcan::scan(as_bytes(text)).kind, Scan::Kind::bad_checksum) << line;
  }
}

TEST(Slcan, ADamagedFramesTailIsNeverTakenForACommand) {
  // "C\r" would close the channel.
  const auto cut = cut_stream<Slcan>({"tX2322BBC\rt1231AA\r"});
  EXPECT_EQ(cut.frames, (std::vector<std::string>{"t1231AA\r"}));
  EXPECT_EQ(cut.counters.bad_checksums, 1u);
}

TEST(Slcan, FindsTheFrameBehindALostLineEnd) {
  const auto cut = cut_stream<Slcan>({"t1232AAt1231BB\rz\r"});
  EXPECT_EQ(cut.frames, (std::vector<std::string>{"t1231BB\r", "z\r"}));
}

TEST(Slcan, StrayLineFeedsDoNotBreakTheReader) {
  const auto cut = cut_stream<Slcan>({"t1231AA\r\n\nt1231BB\r\n"});
  EXPECT_EQ(cut.frames.size(), 2u);
  EXPECT_EQ(cut.counters.bad_checksums, 0u);
}

TEST(Slcan, ARefusalAmidALineEndsTheLine) {
  const auto cut = cut_stream<Slcan>({"t12\at1231AA\r"});
  EXPECT_EQ(cut.frames, (std::vector<std::string>{"\a", "t1231AA\r"}));
}

TEST(Slcan, KnowsTheBitRatesOfTheAdapters) {
  EXPECT_EQ(slcan::bit_rate_command(250000), "S5");
  EXPECT_EQ(slcan::bit_rate_command(10000), "S0");
  EXPECT_EQ(slcan::bit_rate_command(1000000), "S8");
  EXPECT_FALSE(slcan::bit_rate_command(123456));
  EXPECT_EQ(slcan::bit_rate_of("S6"), 500000u);
  EXPECT_FALSE(slcan::bit_rate_of("S9"));
}

TEST(Slcan, CanFdAndErrorFramesHaveNoForm) {
  EXPECT_EQ(encoded(Frame{test::frame("123##111"), {}}), "");
  EXPECT_EQ(encoded(Frame{test::frame("20000004#0004000000000000"), {}}), "");
}

RC_GTEST_PROP(Slcan, AnySplitGivesTheSameFrames, ()) {
  const std::vector<std::string> parts{"t1232AABB\r", "T12345678108\r",
                                       "r123\r",      "z\r",
                                       "\r",          "\a",
                                       "S6\r",        "O\r",
                                       "t12",         "\n",
                                       "xyz",         "C"};
  std::string text;
  for (const auto& part :
       *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(parts))) {
    text += part;
  }
  RC_ASSERT(cut_stream<Slcan>(test::split_at_random(text)) == cut_stream<Slcan>({text}));
}

RC_GTEST_PROP(Slcan, AGoodFrameSurvivesAnyNoiseBeforeIt, ()) {
  // Noise of hex digits and letters of other lines. It contains no frame letter (t T r R): such a
  // letter could take the good frame as its data.
  const auto noise = *rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("0123456789ABCDEFabcdefOCLSVvNFZzMm\r\n\a")));
  const std::string good = "t1232AABB\r";
  const auto cut = cut_stream<Slcan>({noise + good});
  RC_ASSERT(!cut.frames.empty());
  RC_ASSERT(cut.frames.back() == good);
  RC_ASSERT(cut.counters.bytes_in ==
            cut.counters.bytes_good + cut.counters.bytes_skipped + cut.held);
}

RC_GTEST_PROP(Slcan, AnyBytesAreCutWithoutHarm, (const std::string& bytes)) {
  const auto cut = cut_stream<Slcan>({bytes});
  for (const auto& frame : cut.frames) RC_ASSERT(Slcan::decode(as_bytes(frame)).has_value());
}

}  // namespace slcan_test
}  // namespace drydock::wire
