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
              HasSubstr("$GPSX 28.648 57.296 12.5*"));
}

TEST(TextsBetweenBlanks, HaveNoEmptyConstant) {
  std::string text = by_blanks;
  text.replace(text.find("{ name = \"volts\""), 16, "{ text = \"\" }, { name = \"volts\"");
  EXPECT_THAT(problems_of(text), HasSubstr("a run of blanks is one separator"));
}

}  // namespace emulated_forms_test
}  // namespace drydock::described::test
