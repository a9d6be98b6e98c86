#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numeric>

#include "tests/drivers/described/support.hpp"
#include "tests/drivers/device/allocation_count.hpp"
#include "tests/drivers/property.hpp"

/// Packets between delimiters.
namespace drydock::described::test {
namespace stuffing_test {

using ::testing::HasSubstr;
using wire::Scan;
using wire::described::Packet;
using wire::described::Stuffing;
using wire::testing::Buffer;

Buffer unstuffed(Stuffing stuffing, const Buffer& frame) {
  Packet packet;
  EXPECT_TRUE(wire::described::unstuff(stuffing, frame, packet));
  return {packet.begin(), packet.end()};
}

Buffer stuffed(Stuffing stuffing, const Buffer& packet) {
  Buffer out(3 * packet.size() + 8);
  out.resize(wire::described::stuff(stuffing, packet, out));
  return out;
}

Buffer counting(unsigned from, unsigned to) {
  Buffer bytes(to - from + 1);
  std::iota(bytes.begin(), bytes.end(), static_cast<std::uint8_t>(from));
  return bytes;
}

Buffer joined(std::initializer_list<Buffer> parts) {
  Buffer all;
  for (const Buffer& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

// The examples of Wikipedia's page on consistent overhead byte stuffing.
TEST(StuffingCobs, IsThatOfThePublishedExamples) {
  const std::pair<Buffer, Buffer> examples[] = {
      {{0x00}, {0x01, 0x01, 0x00}},
      {{0x00, 0x00}, {0x01, 0x01, 0x01, 0x00}},
      {{0x00, 0x11, 0x00}, {0x01, 0x02, 0x11, 0x01, 0x00}},
      {{0x11, 0x22, 0x00, 0x33}, {0x03, 0x11, 0x22, 0x02, 0x33, 0x00}},
      {{0x11, 0x22, 0x33, 0x44}, {0x05, 0x11, 0x22, 0x33, 0x44, 0x00}},
      {{0x11, 0x00, 0x00, 0x00}, {0x02, 0x11, 0x01, 0x01, 0x01, 0x00}},
      {counting(1, 254), joined({{0xFF}, counting(1, 254), {0x00}})},
      {counting(0, 254), joined({{0x01, 0xFF}, counting(1, 254), {0x00}})},
      {counting(1, 255), joined({{0xFF}, counting(1, 254), {0x02, 0xFF, 0x00}})},
      {joined({counting(2, 255), {0x00}}), joined({{0xFF}, counting(2, 255), {0x01, 0x01, 0x00}})},
      {joined({counting(3, 255), {0x00, 0x01}}),
       joined({{0xFE}, counting(3, 255), {0x02, 0x01, 0x00}})}};
  for (const auto& [packet, frame] : examples) {
    EXPECT_EQ(stuffed(Stuffing::cobs, packet), frame);
    EXPECT_EQ(unstuffed(Stuffing::cobs, frame), packet);
  }
}

// RFC 1055: END is C0h, ESC DBh. RFC 1662: 7Eh is sent as 7Dh 5Eh, 7Dh as 7Dh 5Dh.
TEST(StuffingSlipAndHdlc, AreThoseOfTheirRfcs) {
  EXPECT_EQ(stuffed(Stuffing::slip, {0x01, 0xC0, 0xDB, 0x02}),
            (Buffer{0xC0, 0x01, 0xDB, 0xDC, 0xDB, 0xDD, 0x02, 0xC0}));
  EXPECT_EQ(stuffed(Stuffing::hdlc, {0x7E, 0x11, 0x7D}),
            (Buffer{0x7E, 0x7D, 0x5E, 0x11, 0x7D, 0x5D, 0x7E}));
  // RFC 1662 lets a sender turn control characters too: XON as 7Dh 31h.
  EXPECT_EQ(unstuffed(Stuffing::hdlc, {0x7E, 0x7D, 0x31, 0x11, 0x7E}), (Buffer{0x11, 0x11}));
  Packet packet;
  EXPECT_FALSE(wire::described::unstuff(Stuffing::slip, Buffer{0xC0, 0xDB, 0x01, 0xC0}, packet));
}

/// A NGT-1 of Actisense hears this (canboat's start-up sequence): DLE STX, command, length,
/// content, a sum that makes all 0, DLE ETX.
constexpr const char* actisense = R"(
[sensor]
title = "NGT-1"
[protocol]
stuffing = "dle"
checksum = "sum-8-negative"
checksum_from = 1
[[protocol.binary]]
name = "command"
sync = "02 A1"
length = { at = 2, type = "u8", plus = 4 }
fields = [{ at = 3, type = "u8", name = "first" }]
)";

TEST(StuffedDle, ReadsThePacketsOfOtherPrograms) {
  const auto description = described(actisense);
  const auto& plan = description->plan;
  const Buffer frame{0x10, 0x02, 0xA1, 0x03, 0x11, 0x02, 0x00, 0x49, 0x10, 0x03};
  EXPECT_EQ(wire::described::scan(plan, frame), Scan::frame(10));
  EXPECT_EQ(wire::described::scan(plan, wire::Bytes(frame).first(9)), Scan::need_more());
  wire::described::Record record;
  ASSERT_EQ(wire::described::decode(plan, frame, record), wire::described::Decoded::message);
  EXPECT_EQ(value_of(record, "first"), 0x11);
  // 10h in the content is doubled on the line.
  const Buffer doubled{0x10, 0x02, 0xA1, 0x02, 0x10, 0x10, 0x20, 0x2D, 0x10, 0x03};
  ASSERT_EQ(wire::described::scan(plan, doubled), Scan::frame(10));
  ASSERT_EQ(wire::described::decode(plan, doubled, record), wire::described::Decoded::message);
  EXPECT_EQ(value_of(record, "first"), 0x10);
  Buffer damaged = frame;
  damaged[7] = 0x4A;
  EXPECT_EQ(wire::described::scan(plan, damaged).kind, Scan::Kind::bad_checksum);
}

TEST(StuffedDle, APacketThatIsCutOffHidesNotTheNext) {
  const auto description = described(actisense);
  const Buffer frame{0x10, 0x02, 0xA1, 0x03, 0x11, 0x02, 0x00, 0x49, 0x10, 0x03};
  const Buffer both = joined({Buffer(frame.begin(), frame.begin() + 5), frame});
  const Scan first = wire::described::scan(description->plan, both);
  EXPECT_EQ(first.kind, Scan::Kind::bad_checksum);
  ASSERT_EQ(first.size, 5u);
  EXPECT_EQ(wire::described::scan(description->plan, wire::Bytes(both).subspan(5)),
            Scan::frame(10));
}

std::string depth_by(std::string_view stuffing) {
  return fmt::format(R"(
[sensor]
title = "A sounder of my own"
kind = "depth"
[protocol]
stuffing = "{}"
checksum = "crc-16/x-25"
[[protocol.binary]]
name = "depth"
sync = "7E 10"
fields = [{{ at = 2, type = "i32", field = "depth_m", unit = "mm" }}]
)",
                     stuffing);
}

TEST(StuffedFrames, AreReadAsTheyAreWritten) {
  for (const char* stuffing : {"dle", "slip", "hdlc", "cobs"}) {
    const auto description = described(depth_by(stuffing));
    const auto& plan = description->plan;
    Buffer stream;
    for (int mm = -300; mm < 300; ++mm) {
      wire::described::Readings readings;
      readings.set(wire::described::Target::depth, mm * 1e-3);
      std::array<std::uint8_t, 64> out{};
      const std::size_t size = wire::described::encode(plan, plan.messages[0], readings, out);
      stream.insert(stream.end(), out.begin(), out.begin() + static_cast<long>(size));
    }
    int mm = -300;
    wire::Framer<wire::described::longest_frame> framer;
    framer.feed(stream, wire::described::Scanner{&plan}, [&](wire::Bytes frame, std::size_t) {
      wire::described::Record record;
      ASSERT_EQ(wire::described::decode(plan, frame, record), wire::described::Decoded::message);
      EXPECT_NEAR(value_of(record, "depth_m"), mm++ * 1e-3, 1e-12) << stuffing;
    });
    EXPECT_EQ(mm, 300) << stuffing;
    EXPECT_EQ(framer.counters().bytes_skipped, 0u) << stuffing;
  }
}

// RFC 1662: one flag may end a packet and begin the next. Idle lines send flags.
TEST(StuffedFrames, ShareADelimiterAndWaitBehindIdleOnes) {
  const auto description = described(depth_by("hdlc"));
  const auto& plan = description->plan;
  wire::described::Readings readings;
  readings.set(wire::described::Target::depth, 1.5);
  Buffer one(64);
  one.resize(wire::described::encode(plan, plan.messages[0], readings, one));
  const Buffer stream =
      joined({Buffer(5, 0x7E), one, Buffer(one.begin() + 1, one.end()), Buffer{0x33, 0x44}, one});
  int frames = 0;
  wire::Framer<wire::described::longest_frame> framer;
  framer.feed(stream, wire::described::Scanner{&plan}, [&](wire::Bytes, std::size_t) { ++frames; });
  EXPECT_EQ(frames, 3);
  EXPECT_EQ(framer.counters().bytes_skipped, 5u + 2u);
}

// A name of more than 15 bytes: a copy of the message would allocate.
TEST(StuffedFrames, AreReadWithoutAnAllocation) {
  std::string text = depth_by("slip");
  text.replace(text.find("name = \"depth\""), 14, "name = \"depth_below_the_transducer\"");
  const auto description = described(text);
  const auto& plan = description->plan;
  wire::described::Readings readings;
  readings.set(wire::described::Target::depth, 1.5);
  Buffer one(64);
  one.resize(wire::described::encode(plan, plan.messages[0], readings, one));
  wire::described::Record record;
  const device::test::AllocationCount allocations;
  ASSERT_EQ(wire::described::scan(plan, one), Scan::frame(one.size()));
  ASSERT_EQ(wire::described::decode(plan, one, record), wire::described::Decoded::message);
  EXPECT_EQ(allocations.so_far(), 0u);
}

TEST(StuffedFrames, AreOfBinaryMessagesAlone) {
  EXPECT_THAT(problems_of("[sensor]\ntitle = \"x\"\n[protocol]\nstuffing = \"slip\"\n"
                          "[[protocol.sentences]]\nid = \"$ALT\"\nfields = [{ name = \"a\" }]\n"),
              HasSubstr("toy.toml:4:12: /protocol/stuffing: only binary frames"));
}

}  // namespace stuffing_test
}  // namespace drydock::described::test
