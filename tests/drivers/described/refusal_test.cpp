#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "rig_config/device_description/units.hpp"
#include "tests/drivers/described/support.hpp"

/// A description that is wrong is refused with file, line, column and what is allowed.
namespace drydock::described::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view head =
    "[sensor]\ntitle = \"t\"\nkind = \"depth\"\n[protocol]\n";  // lines 1 to 4

std::string with(std::string_view more) {
  return problems_of(std::string(head) + std::string(more));
}

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

TEST(DescriptionProblems, TwoMessagesOfTheSameBytesAreRefused) {
  EXPECT_THAT(with("[[protocol.sentences]]\nid = \"$PX\"\nfields = [{field = \"depth_m\", unit = "
                   "\"m\"}]\n[[protocol.sentences]]\nid = \"$--\"\nname = \"other\"\n"
                   "fields = [{name = \"x\"}]\n[[protocol.sentences]]\nid = \"$PX\"\n"
                   "name = \"third\"\nfields = [{name = \"y\"}]\n"),
              HasSubstr("toy.toml:12:1: /protocol/sentences/2: the same bytes can be this message "
                        "and that of line 5"));
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

TEST(DescriptionProblems, ARigNamesADescriptionAndItsFactsDecide) {
  const auto rig = [](std::string_view protocol, std::string_view more = {}) {
    const auto loaded = rig_config::load_rig_text(
        "[rig]\nname = \"r\"\n[[device]]\nname = \"vat\"\nkind = \"depth\"\nprotocol = \"" +
            std::string(protocol) + "\"\nlink = \"pty:vat\"\n" + std::string(more),
        "r.toml");
    std::string lines;
    if (!loaded)
      for (const auto& problem : loaded.error()) lines += to_string(problem) + "\n";
    return lines;
  };
  EXPECT_THAT(rig("valeport-vat.toml"), IsEmpty());
  EXPECT_THAT(rig("nothing.toml"),
              HasSubstr("r.toml:6:12: /device/0/protocol: nothing.toml: there is no such "
                        "description; neither as a file nor among those of the program: "));
  EXPECT_THAT(rig("cerulean-dvpdl.toml"), HasSubstr("\"cerulean-dvpdl.toml\" is not allowed"));
  EXPECT_THAT(rig("valeport-vat.toml", "[[fault]]\ndevice = \"vat\"\nfault = \"bad-checksum\"\n"),
              IsEmpty());
  EXPECT_THAT(rig("digiquartz.toml", "[[fault]]\ndevice = \"vat\"\nfault = \"bad-checksum\"\n"),
              HasSubstr("its protocol has no checksum of its own"));
  EXPECT_THAT(rig("valeport-vat.toml",
                  "[[fault]]\ndevice = \"vat\"\nfault = \"clock-step\"\nseconds = 1\n"),
              HasSubstr("no time of its own clock"));
}

TEST(DescriptionProblems, AMisspelledDescriptionIsToldBesideTheRigsOtherMistakes) {
  const auto loaded = rig_config::load_rig_text(
      "[rig]\nname = \"r\"\n[[device]]\nname = \"compass\"\nkind = \"atitude\"\nprotocol = "
      "\"nmea2000\"\nlink = \"can:auto\"\n[[device]]\nname = \"vat\"\nkind = \"depth\"\n"
      "protocol = \"valport-vat.toml\"\nlink = \"pty:vat\"\n",
      "r.toml");
  ASSERT_FALSE(loaded);
  ASSERT_EQ(loaded.error().size(), 2u);
  EXPECT_THAT(to_string(loaded.error()[0]), HasSubstr("r.toml:5:8: /device/0/kind: "));
  EXPECT_THAT(to_string(loaded.error()[1]),
              HasSubstr("r.toml:11:12: /device/1/protocol: valport-vat.toml: there is no such "
                        "description (did you mean 'valeport-vat.toml'?)"));
}

TEST(DescriptionProblems, AFileBesideTheRigComesBeforeThatOfTheProgramAndIsOneOfItsFiles) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(::testing::TempDir()) / "described-beside";
  fs::create_directories(folder);
  const auto path = (folder / "r.toml").string();
  const std::string rig =
      "[rig]\nname = \"r\"\n[[device]]\nname = \"vat\"\nkind = \"depth\"\n"
      "protocol = \"valeport-vat.toml\"\nlink = \"pty:vat\"\n";
  fs::remove(folder / "valeport-vat.toml");
  EXPECT_EQ(rig_config::load_rig_text(rig, path)->files, std::vector{path});
  std::ofstream(folder / "valeport-vat.toml")
      << head
      << "[[protocol.sentences]]\nid = \"$MINE\"\nfields = [{field = \"depth_m\", unit = "
         "\"m\"}]\n";
  const auto loaded = rig_config::load_rig_text(rig, path);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->devices[0].description->plan.messages[0].name, "MINE");
  EXPECT_EQ(loaded->files, (std::vector{path, (folder / "valeport-vat.toml").string()}));
  fs::create_directories(folder / "mine");
  fs::copy_file(folder / "valeport-vat.toml", folder / "mine" / "toy.toml",
                fs::copy_options::overwrite_existing);
  auto below = rig;
  below.replace(below.find("valeport-vat"), 12, "mine/toy");
  EXPECT_TRUE(rig_config::load_rig_text(below, path)) << "a path below the rig's folder";
  std::ofstream(folder / "valeport-vat.toml") << head << "order = \"up\"\n";
  const auto wrong = rig_config::load_rig_text(rig, path);
  ASSERT_FALSE(wrong);
  EXPECT_THAT(to_string(wrong.error().front()),
              HasSubstr("valeport-vat.toml:5:9: /protocol/order: \"up\" is not allowed"));
}

TEST(DescriptionProblems, ThePageNamesEveryUnitAndEveryField) {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/docs/sensors/described.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  for (const auto& unit : rig_config::wire_units)
    EXPECT_NE(page.find("`" + std::string(unit.name) + "`"), page.npos) << unit.name;
  for (const auto& row : wire::described::target_rows) {
    if (row.name.starts_with("covariance") || row.name.starts_with("range_")) continue;
    EXPECT_NE(page.find("`" + std::string(row.name) + "`"), page.npos) << row.name;
  }
  for (const auto& [name, text] : rig_config::built_in_descriptions())
    EXPECT_NE(page.find("| `" + std::string(name) + "` |"), page.npos) << name;
}

TEST(DescriptionProblems, UnitsHaveTheirValuesOfSi) {
  const auto si = [](std::string_view name, double figure) {
    const auto* unit = rig_config::find_unit(name);
    EXPECT_NE(unit, nullptr) << name;
    return figure * unit->factor + unit->offset;
  };
  EXPECT_DOUBLE_EQ(si("fathom", 1), 1.8288);
  EXPECT_DOUBLE_EQ(si("kn", 1), 1852.0 / 3600);
  EXPECT_NEAR(si("psi", 1), 6894.757, 5e-4);   // NIST SP 811: 6.894 757 E+03
  EXPECT_NEAR(si("inHg", 1), 3386.389, 5e-4);  // 3.386 389 E+03, conventional
  EXPECT_NEAR(si("mmHg", 1), 133.3224, 5e-5);  // 1.333 224 E+02
  EXPECT_DOUBLE_EQ(si("mH2O", 1), 9806.65);
  EXPECT_DOUBLE_EQ(si("degC", 25), 298.15);
  EXPECT_NEAR(si("degF", 212), 373.15, 1e-9);
  EXPECT_DOUBLE_EQ(si("mg", 1000), 9.80665);
  EXPECT_NEAR(si("rpm", 60), 2 * 3.14159265358979, 1e-12);
}

}  // namespace
}  // namespace drydock::described::test
