#include <gmock/gmock.h>

#include "tests/drivers/described/support.hpp"

/// Texts whose fields end in other ways than by a comma. The lines are written by hand.
namespace drydock::described::test {
namespace line_ends_test {

using ::testing::HasSubstr;
using wire::described::Decoded;
using wire::described::Record;
using wire::testing::as_bytes;
using wire::testing::Buffer;

std::string lines(const std::string& protocol, const std::string& fields) {
  return "[sensor]\ntitle = \"toy\"\nkind = \"depth\"\n[protocol]\n" + protocol +
         "[[protocol.lines]]\nname = \"line\"\nhead = \"\"\nfields = [" + fields + "]\n";
}

bool reads(const DescriptionPtr& description, std::string_view line, Record& record) {
  return decode(description->plan, as_bytes(line), record) == Decoded::message;
}

/// An altimeter that streams "012.345m": the unit stands behind the number without a blank.
TEST(LineEnds, ALastFieldMayHaveAnEndOfItsOwn) {
  const auto toy =
      described(lines("", R"({ field = "altitude_m", unit = "m", ends = "m", width = 7 })"));
  Record record;
  ASSERT_TRUE(reads(toy, "012.345m\r\n", record));
  EXPECT_DOUBLE_EQ(value_of(record, "altitude_m"), 12.345);
  EXPECT_FALSE(reads(toy, "012.345\r\n", record));
  EXPECT_FALSE(reads(toy, "012.345mm\r\n", record));
  EXPECT_FALSE(reads(toy, "012.345m1\r\n", record));
}

TEST(LineEnds, TheEmulatedSensorWritesThatEndToo) {
  const auto toy =
      described(lines("", R"({ field = "altitude_m", unit = "m", ends = "m", width = 7 })"));
  wire::described::Readings readings;
  readings.set(wire::described::Target::altitude, 12.345);
  Buffer out(64);
  const auto size = encode(toy->plan, toy->plan.messages[0], readings, out);
  EXPECT_EQ(wire::testing::as_text(wire::Bytes(out).first(size)), "012.345m\r\n");
}

TEST(LineEnds, ATabSeparatesFieldsAsAnyCharacter) {
  const auto toy = described(
      lines("separator = \"\\t\"\n", R"({ name = "id" }, { field = "depth_m", unit = "m" })"));
  const Buffer line = as_bytes("7\t-3.5\n");
  EXPECT_EQ(wire::described::scan(toy->plan, line), wire::Scan::frame(line.size()));
  Record record;
  ASSERT_TRUE(reads(toy, "7\t-3.5\n", record));
  EXPECT_DOUBLE_EQ(value_of(record, "id"), 7);
  EXPECT_DOUBLE_EQ(value_of(record, "depth_m"), -3.5);
}

}  // namespace line_ends_test
}  // namespace drydock::described::test
