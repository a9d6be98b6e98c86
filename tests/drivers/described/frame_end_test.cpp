#include <gmock/gmock.h>

#include "tests/drivers/described/support.hpp"

/// Bytes behind a checksum, longer frames, the checksums that are no CRC, and descriptions that
/// measure nothing.
namespace drydock::described::test {
namespace frame_end_test {

using ::testing::HasSubstr;
using wire::Scan;
using wire::testing::Buffer;

/// A SkyTraq receiver's frame (application note AN0003): A0 A1, length, content, XOR of it, CR LF.
constexpr const char* skytraq = R"(
[sensor]
title = "SkyTraq"
[protocol]
order = "big"
checksum = "xor"
checksum_from = 4
end = "0D 0A"
[[protocol.binary]]
name = "version"
sync = "A0 A1"
length = { at = 2, type = "u16", plus = 7 }
fields = [{ at = 5, type = "u8", name = "kind" }]
)";

TEST(EndOfAFrame, StandsBehindItsChecksum) {
  const auto description = described(skytraq);
  // The query of the software's version, as the note has it.
  const Buffer frame{0xA0, 0xA1, 0x00, 0x02, 0x02, 0x01, 0x03, 0x0D, 0x0A};
  const auto& plan = description->plan;
  EXPECT_EQ(wire::described::scan(plan, frame), Scan::frame(9));
  EXPECT_EQ(wire::described::scan(plan, wire::Bytes(frame).first(8)), Scan::need_more(9));
  wire::described::Record record;
  ASSERT_EQ(wire::described::decode(plan, frame, record), wire::described::Decoded::message);
  EXPECT_EQ(value_of(record, "kind"), 1);
  Buffer damaged = frame;
  damaged[8] = 0x0B;
  EXPECT_EQ(wire::described::scan(plan, damaged), Scan::bad_checksum());
}

TEST(EndOfAFrame, IsOfBinaryFramesAlone) {
  EXPECT_THAT(problems_of("[sensor]\ntitle = \"x\"\n[protocol]\nend = \"0D\"\n"
                          "[[protocol.sentences]]\nid = \"$ALT\"\nfields = [{ name = \"a\" }]\n"),
              HasSubstr("toy.toml:4:7: /protocol/end: only binary frames"));
}

TEST(PlainChecksums, AreThoseOfPublishedFrames) {
  const auto of = [](std::string_view name, const Buffer& bytes) {
    wire::described::Checksum checksum;
    EXPECT_TRUE(wire::described::Checksum::find(name, checksum));
    return checksum.of(bytes);
  };
  // Xsens MT low-level protocol: GoToConfig is FA FF 30 00 D1.
  EXPECT_EQ(of("sum-8-negative", {0xFF, 0x30, 0x00}), 0xD1u);
  // RevEng's catalogue: the check of CRC-24/LTE-A, the CRC-24Q of RTCM 3.
  EXPECT_EQ(of("crc-24/lte-a", wire::testing::as_bytes("123456789")), 0xCDE703u);
  // SiRF binary protocol: the sum of the payload, without its highest bit.
  EXPECT_EQ(of("sum-15", Buffer(200, 0xFF)), 200u * 0xFF & 0x7FFF);
}

TEST(DescriptionWithoutAKind, IsReadButHasNoDriver) {
  const auto description = described(skytraq);
  EXPECT_FALSE(description->kind);
  EXPECT_TRUE(description->facts.kinds.empty());
}

TEST(DescriptionWithoutAKind, MeasuresNothing) {
  std::string text = skytraq;
  text.replace(text.find("name = \"kind\""), 13, "field = \"depth_m\", unit = \"m\"");
  EXPECT_THAT(problems_of(text), HasSubstr("[sensor] has no key 'kind'"));
}

}  // namespace frame_end_test
}  // namespace drydock::described::test
