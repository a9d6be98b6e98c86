#include <gmock/gmock.h>

#include "tests/drivers/described/with_head.hpp"

/// Binary frames whose fields do not fit are refused with their place.
namespace drydock::described::test {
namespace binary_refusal_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string two_fields(std::string_view a, std::string_view b) {
  return with(
      "checksum = \"sum-8\"\n[[protocol.binary]]\nname = \"a\"\nsync = \"AA 55\"\n"
      "length = 12\nfields = [{" +
      std::string(a) + ", field = \"depth_m\", unit = \"mm\"}, {" + std::string(b) +
      ", field = \"altitude_m\", unit = \"mm\"}]\n");
}

TEST(DescriptionProblems, TwoMeasuredFieldsThatShareBytesInPartAreRefused) {
  EXPECT_THAT(two_fields("at = 2, type = \"u32\"", "at = 4, type = \"u32\""),
              HasSubstr("toy.toml:6:1: /protocol/binary/0: depth_m and altitude_m measure the same "
                        "bytes and are not the same number"));
  EXPECT_THAT(two_fields("at = 2, type = \"u32\"", "at = 2, type = \"f32\", no_value = [0]"),
              HasSubstr("measure the same bytes"));
  EXPECT_THAT(two_fields("at = 2, type = \"u32\", bits = [0, 16]",
                         "at = 2, type = \"u32\", bits = [15, 16]"),
              HasSubstr("measure the same bytes"));
  EXPECT_THAT(two_fields("at = 2, type = \"u32\", bits = [0, 16]",
                         "at = 2, type = \"u32\", bits = [16, 16]"),
              IsEmpty());
  EXPECT_THAT(two_fields("at = 2, type = \"u32\"", "at = 6, type = \"u32\""), IsEmpty());
  EXPECT_THAT(two_fields("at = 2, type = \"u32\"", "at = 2, type = \"u32\""), IsEmpty());
}

TEST(DescriptionProblems, BlocksOfAMaskHaveTheirPlaceAndTheirSizes) {
  const auto with_records = [](std::string_view records, std::string_view field) {
    return with(
        "checksum = \"sum-32\"\n[[protocol.binary]]\nname = \"a\"\nsync = \"AA 55\"\n"
        "length = { at = 4, type = \"u16\" }\nrecords = { " +
        std::string(records) + " }\nfields = [{" + std::string(field) +
        ", field = \"depth_m\", unit = \"m\"}]\n");
  };
  constexpr auto mask = "from = 8, mask = { at = 2, type = \"u16\" }, sizes = [4, 8]";
  constexpr auto field = "record = 1, at = 4, type = \"f32\"";
  EXPECT_THAT(with_records(mask, field), IsEmpty());
  EXPECT_THAT(with_records(mask, "record = 2, at = 4, type = \"f32\""),
              HasSubstr("a field is in block 2, the last that has a size is 1"));
  EXPECT_THAT(with_records(mask, "record = 1, at = 5, type = \"f32\""),
              HasSubstr("field at 5 ends behind the 8 bytes of block 1"));
  EXPECT_THAT(with_records("from = 8, mask = { at = 2, type = \"u16\" }", field),
              HasSubstr("needs 'id' and 'length', or 'mask' and 'sizes'"));
  EXPECT_THAT(with_records("from = 3, mask = { at = 2, type = \"u16\" }, sizes = [4, 8]", field),
              HasSubstr("stands in front of the blocks"));
  EXPECT_THAT(with_records("from = 8, mask = { at = 2, type = \"f32\" }, sizes = [4, 8]", field),
              HasSubstr("a mask has a type u8, u16, u24 or u32"));
  EXPECT_THAT(with_records(
                  "from = 8, mask = { at = 2, type = \"u8\" }, sizes = [1,1,1,1,1,1,1,1,9]", field),
              HasSubstr("has 9 sizes, the mask has 8 bits"));
}

/// RFC 1145 and UBX send the sum of the bytes first, whatever the order of the numbers is.
TEST(DescriptionProblems, TheOrderOfNumbersTurnsNoFletcherSumsInSilence) {
  const auto with_order = [](std::string_view order) {
    return with("checksum = \"fletcher-16\"\n" + std::string(order) +
                "[[protocol.binary]]\nname = \"a\"\nsync = \"AA 55\"\nlength = 8\nfields = [{at = "
                "2, type = \"u32\", field = \"depth_m\", unit = \"mm\"}]\n");
  };
  EXPECT_THAT(with_order("order = \"big\"\n"),
              HasSubstr("toy.toml:5:12: /protocol/checksum: its two sums would change places"));
  EXPECT_THAT(with_order("order = \"big\"\nchecksum_order = \"little\"\n"), IsEmpty());
  EXPECT_THAT(with_order("order = \"big\"\nchecksum_order = \"big\"\n"), IsEmpty());
  EXPECT_THAT(with_order(""), IsEmpty());
}

TEST(DescriptionProblems, ABinaryFieldOutsideItsFrameIsRefused) {
  const auto frame = [](std::string_view field) {
    return with(
        "checksum = \"xor\"\n[[protocol.binary]]\nname = \"a\"\nsync = \"A5 5A\"\n"
        "length = 8\nfields = [" +
        std::string(field) + "]\n");
  };
  EXPECT_THAT(frame("{at = 3, type = \"f32\", field = \"depth_m\", unit = \"m\"}"), IsEmpty());
  EXPECT_THAT(frame("{at = 4, type = \"f32\", field = \"depth_m\", unit = \"m\"}"),
              HasSubstr("toy.toml:6:1: /protocol/binary/0: field at 4 ends behind byte 6"));
  EXPECT_THAT(frame("{at = 3, type = \"f16\", field = \"depth_m\", unit = \"m\"}"),
              HasSubstr("\"f16\" is no type, allowed: u8"));
  EXPECT_THAT(frame("{at = 3, type = \"u8\", bits = [4, 5], field = \"depth_m\", unit = \"m\"}"),
              HasSubstr("bits 4 to 8 are beyond the 8 of u8"));
}

TEST(DescriptionProblems, ABinaryFieldInTheSyncAndAConstantThatDoesNotFitAreRefused) {
  const auto frame = [](std::string_view field) {
    return with(
        "[[protocol.binary]]\nname = \"a\"\nsync = \"A5 5A\"\nlength = 8\n"
        "fields = [{at = 4, type = \"f32\", field = \"depth_m\", unit = \"m\"}, " +
        std::string(field) + "]\n");
  };
  EXPECT_THAT(frame("{at = 1, type = \"u8\", name = \"x\"}"),
              HasSubstr("field at 1 is in the sync, which ends at byte 1"));
  EXPECT_THAT(frame("{at = 2, type = \"u8\", is = 300}"), HasSubstr("300 has more than 8 bits"));
  EXPECT_THAT(frame("{at = 2, type = \"u8\", bits = [4, 3], is = 8}"),
              HasSubstr("8 has more than 3 bits"));
  EXPECT_THAT(frame("{at = 2, type = \"u8\", bits = [4, 3], is = 7}"), IsEmpty());
}

TEST(DescriptionProblems, BinaryFramesOfOneSyncNeedAChecksumToTellTheirLengths) {
  const auto two = [](std::string_view sum) {
    return with(
        "checksum = \"" + std::string(sum) +
        "\"\n[[protocol.binary]]\nname = \"a\"\nsync = \"A5\"\nlength = 9\nfields = [{at = 1, "
        "type = \"f32\", field = \"depth_m\", unit = \"m\"}]\n"
        "[[protocol.binary]]\nname = \"b\"\nsync = \"A5\"\nlength = 5\n");
  };
  EXPECT_THAT(two("crc-16/modbus"), IsEmpty());
  EXPECT_THAT(two("xor"), HasSubstr("the same bytes can be this message"));
}

}  // namespace binary_refusal_test
}  // namespace drydock::described::test
