#include "drivers/wire/described/codec.hpp"
#include "tests/drivers/described/support.hpp"

/// Sentences and lines that are not as NMEA 0183 has them.
namespace drydock::described::test {
namespace {

using namespace wire::testing;
using wire::described::Decoded;
using wire::described::Record;

constexpr std::string_view compass = R"(
[sensor]
title = "a compass whose letters stand between its numbers"
kind = "attitude"
[[protocol.sentences]]
head = "$C"
fields = [
  { field = "heading_deg", unit = "deg", ends = "P", decimals = 1 },
  { field = "pitch_deg", unit = "deg", ends = "R", decimals = 1 },
  { field = "roll_deg", unit = "deg", ends = "T", decimals = 1 },
  { name = "celsius", decimals = 1, emulate = 21.5 },
]
)";

TEST(DescribedSentences, AHeadHasNoSeparatorBehindIt) {
  const auto description = described(compass);
  // The XOR of the characters between $ and * is 37h.
  const Buffer line = as_bytes("$C320.5P0.2R-18.3T20.1*37\r\n");
  EXPECT_EQ(wire::described::scan(description->plan, line), wire::Scan::frame(line.size()));
  Record record;
  ASSERT_EQ(wire::described::decode(description->plan, line, record), Decoded::message);
  EXPECT_EQ(record.type, "C");
  EXPECT_DOUBLE_EQ(value_of(record, "heading_deg"), 320.5);
  EXPECT_DOUBLE_EQ(value_of(record, "roll_deg"), -18.3);
  EXPECT_DOUBLE_EQ(value_of(record, "celsius"), 20.1);
}

TEST(DescribedSentences, AnIdAndAHeadTogetherOrNoneAreRefused) {
  std::string text(compass);
  const auto place = text.find("head = \"$C\"");
  EXPECT_NE(
      problems_of(text.substr(0, place) + "id = \"$C\"\n" + text.substr(place)).find("not both"),
      std::string::npos);
  EXPECT_NE(problems_of(text.erase(place, 11)).find("a sentence needs 'id'"), std::string::npos);
}

std::string sentence_with(std::string_view checksum) {
  return "[sensor]\ntitle = \"toy\"\nkind = \"depth\"\n[protocol]\nchecksum = \"" +
         std::string(checksum) +
         "\"\n[[protocol.sentences]]\nid = \"$PXYZ\"\n"
         "fields = [{ field = \"depth_m\", unit = \"m\", decimals = 3 }]\n";
}

/// Of "PXYZ,12.500", by Python's binascii.crc_hqx and zlib.crc32, which are CRC-16/XMODEM and
/// CRC-32/ISO-HDLC.
TEST(DescribedSentences, AChecksumOfMoreBitsHasMoreDigits) {
  for (const auto& [name, text] : {std::pair("crc-16/xmodem", "$PXYZ,12.500*BF97\r\n"),
                                   std::pair("crc-32", "$PXYZ,12.500*24E52778\r\n")}) {
    const auto description = described(sentence_with(name));
    Buffer line = as_bytes(text);
    EXPECT_EQ(wire::described::scan(description->plan, line), wire::Scan::frame(line.size()));
    Record record;
    ASSERT_EQ(wire::described::decode(description->plan, line, record), Decoded::message);
    EXPECT_DOUBLE_EQ(value_of(record, "depth_m"), 12.5);
    wire::described::Readings readings;
    read(record, readings);
    std::array<std::uint8_t, 64> out{};
    const auto size =
        wire::described::encode(description->plan, description->plan.messages[0], readings, out);
    EXPECT_EQ(Buffer(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)), line);
    line[8] ^= 1;
    EXPECT_EQ(wire::described::scan(description->plan, line), wire::Scan::bad_checksum());
  }
}

TEST(DescribedSentences, ABlankFieldHasNoValueAndIsNotMalformed) {
  const auto description = described(sentence_with("none"));
  Record record;
  ASSERT_EQ(wire::described::decode(description->plan, as_bytes("$PXYZ,   \r\n"), record),
            Decoded::message);
  EXPECT_TRUE(std::isnan(value_of(record, "depth_m")));
  EXPECT_EQ(record.malformed, 0u);
}

/// A degree sign is B0h in Latin-1 and Windows-1252, and C2h B0h in UTF-8.
TEST(DescribedLines, ADegreeSignIsReadInAnyEncodingAndWrittenAsUtf8) {
  const auto probe = described(
      "[sensor]\ntitle = \"toy\"\nkind = \"depth\"\n[[protocol.lines]]\nname = \"t\"\n"
      "head = \"D=\"\npattern = '(?P<d>[-0-9.]+) m, (?P<t>[-0-9.]+) ?[^0-9A-Z]+C'\n"
      "emulate = \"{d} m, {t} \u00B0C\"\n"
      "fields = [{ group = \"d\", field = \"depth_m\", unit = \"m\", decimals = 2 },\n"
      "{ group = \"t\", field = \"temperature_k\", unit = \"degC\", decimals = 1 }]\n");
  for (const std::string_view line : {"D=12.50 m, 8.5 \xB0"
                                      "C\r\n",
                                      "D=12.50 m, 8.5 \xC2\xB0"
                                      "C\r\n"}) {
    Record record;
    const Buffer bytes = as_bytes(line);
    EXPECT_EQ(wire::described::scan(probe->plan, bytes), wire::Scan::frame(bytes.size()));
    ASSERT_EQ(wire::described::decode(probe->plan, bytes, record), Decoded::message);
    EXPECT_DOUBLE_EQ(value_of(record, "temperature_k"), 281.65);
    wire::described::Readings readings;
    read(record, readings);
    std::array<std::uint8_t, 64> out{};
    const auto size = wire::described::encode(probe->plan, probe->plan.messages[0], readings, out);
    EXPECT_EQ(std::string(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)),
              "D=12.50 m, 8.5 \xC2\xB0"
              "C\r\n");
  }
}

TEST(DescribedLines, ColumnsOfAFixedWidthHaveBlanksAtBothEnds) {
  const auto columns = described(
      "[sensor]\ntitle = \"toy\"\nkind = \"depth\"\n[protocol]\nseparator = \" \"\n"
      "[[protocol.lines]]\nname = \"sv\"\nhead = \"\"\nfields = [{ name = \"speed\" }, "
      "{ field = \"depth_m\", unit = \"m\" }, { name = \"celsius\" }]\n");
  for (const std::string_view line :
       {"1500.123  12.50  8.25\r\n", "1500.123     12.50     8.25   \r\n"}) {
    Record record;
    const Buffer bytes = as_bytes(line);
    EXPECT_EQ(wire::described::scan(columns->plan, bytes), wire::Scan::frame(bytes.size()));
    ASSERT_EQ(wire::described::decode(columns->plan, bytes, record), Decoded::message) << line;
    EXPECT_DOUBLE_EQ(value_of(record, "depth_m"), 12.5);
    EXPECT_DOUBLE_EQ(value_of(record, "celsius"), 8.25);
  }
}

}  // namespace
}  // namespace drydock::described::test
