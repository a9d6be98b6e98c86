#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/wire/text_fields.hpp"
#include "tests/drivers/described/support.hpp"

/// What an emulated device can write where its form has limits.
namespace drydock::described::test {
namespace emulated_forms_test {

using ::testing::HasSubstr;
using wire::described::Readings;
using wire::described::Target;
using wire::testing::Buffer;

Buffer written(const DescriptionPtr& description, const Readings& readings) {
  const auto& plan = description->plan;
  Buffer out(128);
  out.resize(wire::described::encode(plan, plan.messages[0], readings, out));
  return out;
}

Readings heading(double degrees) {
  Readings readings;
  readings.set(Target::heading, degrees * M_PI / 180);
  return readings;
}

// An i16 of 0.01 degrees ends at 327.67, and of 180/32768 degrees before 180.
TEST(EmulatedHeadings, AreTheSameAngleInASignedNumber) {
  const auto of = [](std::string_view scale) {
    return described(fmt::format(R"(
[sensor]
title = "compass"
kind = "attitude"
[protocol]
[[protocol.binary]]
name = "yaw"
sync = "AA"
length = 3
fields = [{{ at = 1, type = "i16", field = "heading_deg", unit = "deg", scale = {} }}]
)",
                                 scale));
  };
  EXPECT_EQ(written(of("0.01"), heading(340)), (Buffer{0xAA, 0x30, 0xF8}));             // -2000
  EXPECT_EQ(written(of("0.0054931640625"), heading(270)), (Buffer{0xAA, 0x00, 0xC0}));  // -16384
  EXPECT_EQ(written(of("0.01"), heading(90)), (Buffer{0xAA, 0x28, 0x23}));              // 9000
}

constexpr const char* by_blanks = R"(
[sensor]
title = "x"
kind = "gnss"
[protocol]
separator = " "
[[protocol.sentences]]
id = "$GPSX"
fields = [
  { field = "latitude_deg", unit = "deg" },
  { field = "longitude_deg", unit = "deg" },
  { name = "volts", optional = true, emulate = 12.5, decimals = 1 },
]
)";

TEST(TextsBetweenBlanks, AreNotSentWithoutAValue) {
  const auto description = described(by_blanks);
  Readings readings;
  EXPECT_TRUE(written(description, readings).empty());
  readings.set(Target::latitude, 0.5);
  EXPECT_TRUE(written(description, readings).empty());
  readings.set(Target::longitude, 1);
  EXPECT_THAT(std::string(wire::as_text(written(description, readings))),
              HasSubstr("$GPSX 28.6478898 57.2957795 12.5*"));
}

TEST(TextsBetweenBlanks, HaveNoEmptyConstant) {
  std::string text = by_blanks;
  text.replace(text.find("{ name = \"volts\""), 16, "{ text = \"\" }, { name = \"volts\"");
  EXPECT_THAT(problems_of(text), HasSubstr("a run of blanks is one separator"));
}

std::string text_of(const DescriptionPtr& description, const Readings& readings) {
  const Buffer bytes = written(description, readings);
  return std::string(wire::as_text(bytes));
}

/// A thousandth of a degree is 111 m.
TEST(EmulatedPositions, HaveStepsOfACentimetreUnlessTheFileSaysOtherwise) {
  const auto of = [](std::string_view unit, std::string_view more) {
    Readings readings;
    readings.set(Target::latitude, 36.1234567 * M_PI / 180);
    readings.set(Target::longitude, 129.7654321 * M_PI / 180);
    return text_of(described(fmt::format(R"(
[sensor]
title = "receiver"
kind = "gnss"
[protocol]
checksum = "none"
[[protocol.sentences]]
id = "$POS"
fields = [
  {{ field = "latitude_deg", unit = "{0}"{1} }},
  {{ field = "longitude_deg", unit = "{0}"{1} }},
]
)",
                                         unit, more)),
                   readings);
  };
  EXPECT_EQ(of("deg", ""), "$POS,36.1234567,129.7654321\r\n");
  EXPECT_EQ(of("ddmm", ""), "$POS,3607.40740,12945.92593\r\n");
  EXPECT_EQ(of("deg", ", decimals = 2"), "$POS,36.12,129.77\r\n");
}

/// GGK of a Trimble receiver has its height as EHT116.901; a VectorNav's mode is bits 0 and 1.
constexpr std::string_view odd_fields = R"(
[sensor]
title = "receiver"
kind = "gnss"
[protocol]
[[protocol.sentences]]
id = "$PTNL"
fields = [
  { field = "ellipsoidal_height_m", unit = "m", before = "EHT" },
  { name = "mode", type = "hex", bits = [0, 2] },
  { name = "error", type = "hex", bits = [3, 4] },
]
)";

wire::described::Record record_of(const DescriptionPtr& description, const Buffer& frame) {
  wire::described::Record record;
  wire::described::decode(description->plan, frame, record);
  return record;
}

TEST(OddFields, ATextInFrontOfANumberAndBitsOfAHexadecimalOneAreRead) {
  const auto description = described(odd_fields);
  const auto record =
      record_of(description, wire::testing::as_bytes("$PTNL,EHT116.901,0x7E,7E*00\r\n"));
  EXPECT_EQ(value_of(record, "ellipsoidal_height_m"), 116.901);
  EXPECT_EQ(value_of(record, "mode"), 2);    // 7Eh = 111 1110
  EXPECT_EQ(value_of(record, "error"), 15);  // its bits 3 to 6
  Readings readings;
  readings.set(Target::ellipsoidal_height, 116.901);
  EXPECT_THAT(text_of(description, readings), HasSubstr("$PTNL,EHT116.901,"));
}

TEST(OddFields, AnotherTextInFrontOfTheNumberIsNoNumber) {
  const auto description = described(odd_fields);
  const auto record =
      record_of(description, wire::testing::as_bytes("$PTNL,GHT116.901,0,0*00\r\n"));
  EXPECT_TRUE(std::isnan(value_of(record, "ellipsoidal_height_m")));
  EXPECT_EQ(record.malformed, 1u);
}

TEST(OddFields, BitsOfADecimalNumberAreRefused) {
  EXPECT_THAT(problems_of(R"(
[sensor]
title = "x"
kind = "depth"
[protocol]
[[protocol.sentences]]
id = "$X"
fields = [{ field = "depth_m", unit = "m", bits = [0, 2] }]
)"),
              HasSubstr("only a number of type \"hex\" has bits"));
}

/// `longest` is 256 unless the file says otherwise, and a driver reads no longer sentence.
TEST(EmulatedForms, ASentenceThatIsLongerThanTheLongestIsRefused) {
  std::string fields;
  for (int i = 0; i < 30; ++i) fields += fmt::format("{{ name = \"c{}\", decimals = 12 }},\n", i);
  const auto text = [&](std::string_view longest) {
    return fmt::format(R"(
[sensor]
title = "x"
kind = "depth"
[protocol]
{}
[[protocol.sentences]]
id = "$X"
fields = [{{ field = "depth_m", unit = "m" }},
{}]
)",
                       longest, fields);
  };
  EXPECT_THAT(problems_of(text("")), HasSubstr("'longest' under [protocol] says more"));
  EXPECT_EQ(problems_of(text("longest = 1024")), "");
}

}  // namespace emulated_forms_test
}  // namespace drydock::described::test
