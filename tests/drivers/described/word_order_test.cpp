#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/drivers/described/support.hpp"

/// Numbers of two registers and more, as Modbus devices have them: the bytes of 123.456 as a float
/// are 42 F6 E9 79 (IEEE 754), and a maker may send its words or its bytes in another order.
namespace drydock::described::test {
namespace word_order_test {

using namespace wire::testing;
using ::testing::HasSubstr;
using wire::described::Decoded;
using wire::described::Record;

std::string registers(const std::string& order, const std::string& type) {
  return fmt::format(R"(
[sensor]
title = "toy"
[protocol]
order = "{}"
[[protocol.binary]]
name = "registers"
sync = "A5"
length = 9
fields = [{{ at = 1, type = "{}", name = "value", emulate = {} }}]
)",
                     order, type, type == "f32" ? "123.456" : "-2");
}

struct Case {
  const char *order, *type;
  Buffer bytes;
  double value;
};

const auto cases = {
    Case{"big", "f32", {0xA5, 0x42, 0xF6, 0xE9, 0x79, 0, 0, 0, 0}, 123.456F},
    Case{"CDAB", "f32", {0xA5, 0xE9, 0x79, 0x42, 0xF6, 0, 0, 0, 0}, 123.456F},
    Case{"BADC", "f32", {0xA5, 0xF6, 0x42, 0x79, 0xE9, 0, 0, 0, 0}, 123.456F},
    Case{"little", "f32", {0xA5, 0x79, 0xE9, 0xF6, 0x42, 0, 0, 0, 0}, 123.456F},
    Case{"CDAB", "i32", {0xA5, 0xFF, 0xFE, 0xFF, 0xFF, 0, 0, 0, 0}, -2},
    Case{"BADC", "i32", {0xA5, 0xFF, 0xFF, 0xFE, 0xFF, 0, 0, 0, 0}, -2},
    Case{"CDAB", "i64", {0xA5, 0xFF, 0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, -2},
    Case{"BADC", "i16", {0xA5, 0xFE, 0xFF, 0, 0, 0, 0, 0, 0}, -2},
};

TEST(WordOrder, OfAMakerIsReadAndWritten) {
  for (const Case& one : cases) {
    const auto description = described(registers(one.order, one.type));
    Record record;
    ASSERT_EQ(wire::described::decode(description->plan, one.bytes, record), Decoded::message);
    EXPECT_EQ(value_of(record, "value"), one.value) << one.order << " " << one.type;
    Buffer written(16);
    written.resize(
        wire::described::encode(description->plan, description->plan.messages[0], {}, written));
    EXPECT_EQ(written, one.bytes) << one.order << " " << one.type;
  }
}

TEST(WordOrder, OfOneFieldIsItsOwn) {
  auto text = registers("big", "f32");
  text.replace(text.find("name = \"value\""), 14, "order = \"CDAB\", name = \"value\"");
  Record record;
  const Buffer bytes{0xA5, 0xE9, 0x79, 0x42, 0xF6, 0, 0, 0, 0};
  const auto description = described(text);
  ASSERT_EQ(wire::described::decode(description->plan, bytes, record), Decoded::message);
  EXPECT_EQ(value_of(record, "value"), 123.456F);
}

TEST(WordOrder, IsNothingThatThreeBytesHave) {
  EXPECT_THAT(problems_of(registers("CDAB", "u24")), HasSubstr("no number of whole words"));
  EXPECT_EQ(problems_of(registers("CDAB", "u8")), "");
}

}  // namespace word_order_test
}  // namespace drydock::described::test
