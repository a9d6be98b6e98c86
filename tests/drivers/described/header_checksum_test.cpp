#include <gmock/gmock.h>

#include "tests/drivers/described/support.hpp"

/// Checksums that stand in front, and frames that no fixed bytes begin.
namespace drydock::described::test {
namespace header_checksum_test {

using ::testing::HasSubstr;
using wire::Scan;
using wire::testing::Buffer;

std::string without(std::string text, std::string_view part) {
  const auto at = text.find(part);
  EXPECT_NE(at, text.npos);
  return text.erase(at, part.size());
}

/// Packet 39 of Advanced Navigation's protocol (reference manuals, "Packet Structure"), with roll
/// 0.25, pitch -0.125 and heading 3.5 rad. Its CRC is that of Python's binascii.crc_hqx.
const Buffer euler{0xC8, 0x27, 0x0C, 0xC0, 0x45, 0x00, 0x00, 0x80, 0x3E,
                   0x00, 0x00, 0x00, 0xBE, 0x00, 0x00, 0x60, 0x40};

constexpr const char* anpp = R"(
[sensor]
title = "Euler angles"
kind = "attitude"
[protocol]
checksum = "crc-16/ibm-3740"
checksum_at = 3
checksum_from = 5
header_checksum = { checksum = "sum-8-negative", at = 0, from = 1, to = 5 }
[[protocol.binary]]
name = "euler"
length = { at = 2, type = "u8", plus = 5 }
fields = [
  { at = 1, type = "u8", is = 39 },
  { at = 5, type = "f32", field = "roll_deg", unit = "rad" },
  { at = 9, type = "f32", field = "pitch_deg", unit = "rad" },
  { at = 13, type = "f32", field = "heading_deg", unit = "rad" },
]
)";

TEST(ChecksumInFront, IsReadInAFrameThatNoFixedBytesBegin) {
  const auto description = described(anpp);
  const auto& plan = description->plan;
  ASSERT_EQ(wire::described::scan(plan, euler), Scan::frame(17));
  wire::described::Record record;
  ASSERT_EQ(wire::described::decode(plan, euler, record), wire::described::Decoded::message);
  EXPECT_NEAR(value_of(record, "roll_deg"), 0.25 * 180 / M_PI, 1e-9);
  EXPECT_NEAR(value_of(record, "heading_deg"), 3.5 * 180 / M_PI, 1e-9);
}

TEST(ChecksumInFront, OfAHeaderShowsDamageBeforeTheFrameIsWhole) {
  const auto description = described(anpp);
  Buffer damaged = euler;
  damaged[2] = 0xFC;  // 257 bytes would follow
  EXPECT_EQ(wire::described::scan(description->plan, wire::Bytes(damaged).first(5)), Scan::skip(1));
  Buffer content = euler;
  content[10] ^= 1;
  EXPECT_EQ(wire::described::scan(description->plan, content), Scan::bad_checksum());
}

TEST(ChecksumInFront, IsWrittenAsTheMakerWritesIt) {
  const auto description = described(anpp);
  const auto& plan = description->plan;
  wire::described::Readings readings;
  using wire::described::Target;
  readings.set(Target::roll, 0.25);
  readings.set(Target::pitch, -0.125);
  readings.set(Target::heading, 3.5);
  Buffer out(64);
  out.resize(wire::described::encode(plan, plan.messages[0], readings, out));
  EXPECT_EQ(out, euler);
}

/// A block of Septentrio's format (SBF reference guide): "$@", CRC, number, length; the CRC covers
/// all from the number on. Heading 271.5, pitch -1.25, roll 0.5 degrees.
TEST(ChecksumInFront, OfSeptentriosBlocksStandsBehindTheirSync) {
  const Buffer block{0x24, 0x40, 0xBA, 0x07, 0x32, 0x17, 0x2C, 0x00, 0x00, 0x70, 0x99,
                     0x14, 0x98, 0x08, 0x0C, 0x00, 0x02, 0x00, 0x00, 0x00, 0x00, 0xC0,
                     0x87, 0x43, 0x00, 0x00, 0xA0, 0xBF, 0x00, 0x00, 0x00, 0x3F, 0x00,
                     0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
  const auto description = described(R"(
[sensor]
title = "AttEuler"
kind = "attitude"
[protocol]
checksum = "crc-16/xmodem"
checksum_at = 2
checksum_from = 4
[[protocol.binary]]
name = "att_euler"
sync = "24 40"
length = { at = 6, type = "u16" }
fields = [
  { at = 4, type = "u16", bits = [0, 13], is = 5938 },
  { at = 20, type = "f32", field = "heading_deg", unit = "deg" },
  { at = 24, type = "f32", field = "pitch_deg", unit = "deg" },
  { at = 28, type = "f32", field = "roll_deg", unit = "deg" },
]
)");
  ASSERT_EQ(wire::described::scan(description->plan, block), Scan::frame(44));
  wire::described::Record record;
  ASSERT_EQ(wire::described::decode(description->plan, block, record),
            wire::described::Decoded::message);
  EXPECT_NEAR(value_of(record, "heading_deg"), 271.5, 1e-9);
  EXPECT_NEAR(value_of(record, "pitch_deg"), -1.25, 1e-9);
}

/// MAVLink 1: a heartbeat as ground stations show it. Its CRC takes in a byte of the message's
/// definition, 50, that is not sent.
TEST(ChecksumOfMoreThanIsSent, IsThatOfMavlink) {
  const Buffer heartbeat{0xFE, 0x09, 0x4E, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00,
                         0x00, 0x02, 0x03, 0x51, 0x04, 0x03, 0x1C, 0x7F};
  constexpr std::string_view heart = R"(
[sensor]
title = "heartbeat"
[protocol]
checksum = "crc-16/mcrf4xx"
checksum_from = 1
[[protocol.binary]]
name = "heartbeat"
sync = "FE 09"
length = 17
checksum_extra = "32"
fields = [{ at = 5, type = "u8", is = 0 }, { at = 10, type = "u8", name = "kind" }]
)";
  const auto description = described(heart);
  EXPECT_EQ(wire::described::scan(description->plan, heartbeat), Scan::frame(17));
  const auto without_it = described(without(std::string(heart), "checksum_extra = \"32\"\n"));
  EXPECT_EQ(wire::described::scan(without_it->plan, heartbeat), Scan::bad_checksum());
}

TEST(ChecksumInFront, IsNotInWhatItCovers) {
  EXPECT_THAT(problems_of(without(anpp, "checksum_from = 5\n")),
              HasSubstr("/protocol/checksum_at: the checksum stands in what it covers"));
}

TEST(FramesWithoutASync, NeedAConstant) {
  EXPECT_THAT(problems_of(without(anpp, "  { at = 1, type = \"u8\", is = 39 },\n")),
              HasSubstr("a frame needs 'sync', or a constant field"));
}

TEST(FramesWithoutASync, HaveNoFieldInAChecksum) {
  std::string text = anpp;
  text.replace(text.find("{ at = 1, type"), 8, "{ at = 4");
  EXPECT_THAT(problems_of(text), HasSubstr("field at 4 is in a checksum"));
}

}  // namespace header_checksum_test
}  // namespace drydock::described::test
