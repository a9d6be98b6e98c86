#include <gmock/gmock.h>

#include "tests/drivers/described/with_head.hpp"

/// A description that is wrong is refused with file, line, column and what is allowed.
namespace drydock::described::test {
namespace refusal_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(DescriptionProblems, EveryShippedDescriptionIsSound) {
  EXPECT_GE(rig_config::built_in_descriptions().size(), 7u);
  for (const auto& [name, text] : rig_config::built_in_descriptions())
    EXPECT_THAT(problems_of(text), IsEmpty()) << name;
}

TEST(DescriptionProblems, AnUnknownUnitIsRefusedWithThoseOfTheQuantity) {
  EXPECT_EQ(with("[[protocol.sentences]]\nid = \"$PX\"\n"
                 "fields = [{field = \"pressure_pa\", unit = \"m\"}]\n"),
            "toy.toml:7:42: /protocol/sentences/0/fields/0: \"m\" is no unit of pressure_pa, "
            "allowed: Pa, hPa, kPa, MPa, mbar, dbar, bar, psi, inHg, mmHg, mH2O\n");
}

TEST(DescriptionProblems, AFieldThatTheKindDoesNotMeasureIsRefused) {
  EXPECT_THAT(
      with("[[protocol.sentences]]\nid = \"$PX\"\n"
           "fields = [{field = \"depht_m\", unit = \"m\"}]\n"),
      HasSubstr("toy.toml:7:20: /protocol/sentences/0/fields/0: \"depht_m\" is nothing that "
                "a depth measures (did you mean 'depth_m'?), allowed: valid, time_s"));
}

TEST(DescriptionProblems, AnUnknownChecksumIsRefused) {
  EXPECT_THAT(with("checksum = \"crc-16/modbuss\"\n[[protocol.binary]]\nname = \"a\"\n"
                   "sync = \"A5\"\nlength = 8\nfields = [{at = 1, type = \"f32\", field = "
                   "\"depth_m\", unit = \"m\"}]\n"),
              HasSubstr("toy.toml:5:12: /protocol/checksum: \"crc-16/modbuss\" is no checksum (did "
                        "you mean 'crc-16/modbus'?), allowed: none, xor"));
}

TEST(DescriptionProblems, AnIdWithASeparatorIsRefused) {
  EXPECT_THAT(with("[[protocol.sentences]]\nid = \"$PX,YZ\"\nfields = [{field = \"depth_m\", "
                   "unit = \"m\"}]\n"),
              HasSubstr("toy.toml:6:6: /protocol/sentences/0/id: ends before the first ','"));
  EXPECT_THAT(with("separator = \";\"\n[[protocol.sentences]]\nid = \"$PX,YZ\"\nfields = "
                   "[{field = \"depth_m\", unit = \"m\"}]\n"),
              IsEmpty());
}

TEST(DescriptionProblems, TwoMessagesOfTheSameBytesAreRefused) {
  EXPECT_THAT(with("[[protocol.sentences]]\nid = \"$PX\"\nfields = [{field = \"depth_m\", unit = "
                   "\"m\"}]\n[[protocol.sentences]]\nid = \"$--\"\nname = \"other\"\n"
                   "fields = [{name = \"x\"}]\n[[protocol.sentences]]\nid = \"$PX\"\n"
                   "name = \"third\"\nfields = [{name = \"y\"}]\n"),
              HasSubstr("toy.toml:12:1: /protocol/sentences/2: the same bytes can be this message "
                        "and that of line 5"));
}

TEST(DescriptionProblems, ContradictionsAreNamed) {
  const auto sentence = [](std::string_view field) {
    return with(
        "[[protocol.sentences]]\nid = \"$PX\"\nfields = [{field = \"depth_m\", unit = "
        "\"m\"}, " +
        std::string(field) + "]\n");
  };
  EXPECT_THAT(sentence("{name = \"x\", text = \"M\"}"), HasSubstr("a field has one of"));
  EXPECT_THAT(sentence("{field = \"depth_m\", unit = \"m\"}"),
              HasSubstr("two fields of this message are called \"depth_m\""));
  EXPECT_THAT(sentence("{name = \"x\", good = [1]}"), HasSubstr("only for field = \"valid\""));
  EXPECT_THAT(sentence("{field = \"valid\"}"), HasSubstr("needs 'good'"));
  EXPECT_THAT(sentence("{name = \"x\", per = \"depth_m\"}"), HasSubstr("that is a time"));
  EXPECT_THAT(sentence("{field = \"depth_m\", unit = \"m\", per = \"interval_s\"}"),
              HasSubstr("depth_m is nothing that a time divides"));
  EXPECT_THAT(sentence("{name = \"x\", scale = 0}"), HasSubstr("a scale of 0 loses the value"));
  EXPECT_THAT(sentence("{name = \"x\", unit = \"furlong\"}"), HasSubstr("is no unit"));
  EXPECT_THAT(with("[[protocol.sentences]]\nid = \"$PX\"\nfields = [{name = \"x\"}]\n"),
              HasSubstr("no field is part of a measurement"));
  EXPECT_THAT(with("order = \"big\"\n"), HasSubstr("needs one of: sentences, binary, lines"));
  EXPECT_THAT(with("[[protocol.sentences]]\nid = \"$PX\"\nfields = [{field = \"depth_m\", unit = "
                   "\"m\"}]\n[[poll]]\nsend_hex = \"FA F\"\n"),
              HasSubstr("pairs of hexadecimal digits"));
}

TEST(DescriptionProblems, WhatAReplyMustSayIsANumberOfTheReply) {
  const auto start = [](std::string_view more) {
    return with(
        "[[protocol.sentences]]\nid = \"$PX\"\nfields = [{field = \"depth_m\", unit = "
        "\"m\"}, {name = \"mode\"}]\n" +
        std::string(more));
  };
  EXPECT_THAT(start("[[start]]\nsend = \"a\"\nreply = \"PX\"\nsays = { mode = 1 }\n"), IsEmpty());
  EXPECT_THAT(start("[[start]]\nsend = \"a\"\nreply = \"PX\"\nsays = { made = 1 }\n"),
              HasSubstr("PX has no field \"made\""));
  EXPECT_THAT(start("[[start]]\nsend = \"a\"\nreply = \"PX\"\nsays = { mode = \"on\" }\n"),
              HasSubstr("mode must be a number"));
  EXPECT_THAT(start("[[start]]\nsend = \"a\"\nsays = { mode = 1 }\n"),
              HasSubstr("it needs a 'reply'"));
  EXPECT_THAT(start("[[poll]]\nsend = \"a\"\nreply = \"PX\"\nsays = { mode = 1 }\n"),
              HasSubstr("only for requests of the start"));
}

TEST(DescriptionProblems, ADescriptionThatIsTooLargeIsRefused) {
  std::string many = "[[protocol.sentences]]\nid = \"$PX\"\nfields = [";
  for (int i = 0; i < 33; ++i) many += "{name = \"x" + std::to_string(i) + "\"},";
  EXPECT_THAT(with(many + "]\n"), HasSubstr("has 33 values, allowed: 0 to 32"));
}

}  // namespace refusal_test
}  // namespace drydock::described::test
