#include "rig_config/device_description/description_page.hpp"

#include <gmock/gmock.h>

#include "tests/drivers/described/dbc_folder.hpp"

/// The page about a described sensor says how its messages are framed.
namespace drydock::described::test {
namespace description_page_test {

using rig_config::description_page;
using testing::HasSubstr;

std::string page_of(std::string_view protocol) {
  return description_page(*described("[sensor]\ntitle = \"t\"\nkind = \"depth\"\n[protocol]\n" +
                                     std::string(protocol)));
}

TEST(DescriptionPage, OfSentencesNamesTheChecksumAndItsDigits) {
  const auto page = description_page(*shipped("valeport-vat.toml"));
  EXPECT_THAT(page, HasSubstr("- Checksum: xor, 2 hexadecimal digits behind `*`, of the characters "
                              "from 1.\n"));
  EXPECT_THAT(page, HasSubstr("- Begins with `$PRVAT,`.\n"));
}

TEST(DescriptionPage, OfBinaryFramesNamesLengthsChecksumsAndEnd) {
  const auto page = page_of(
      "checksum = \"crc-16/modbus\"\nchecksum_order = \"big\"\nchecksum_from = 2\nend = \"0D 0A\"\n"
      "[[protocol.binary]]\nname = \"fixed\"\nsync = \"A5 01\"\nlength = 10\n"
      "fields = [{ at = 2, type = \"f32\", field = \"pressure_pa\", unit = \"Pa\" }]\n"
      "[[protocol.binary]]\nname = \"told\"\nsync = \"A5 02\"\n"
      "length = { at = 2, type = \"u16\", order = \"big\", plus = 6 }\n"
      "fields = [{ at = 4, type = \"f32\", field = \"pressure_pa\", unit = \"Pa\" }]\n");
  EXPECT_THAT(page, HasSubstr("- Checksum: crc-16/modbus, 2 bytes, high byte first, of the bytes "
                              "from 2 up to it.\n- Each frame ends with 0D 0A.\n"));
  EXPECT_THAT(page, HasSubstr("- Begins with `A5 01`.\n- Length: 10 bytes.\n"));
  EXPECT_THAT(page, HasSubstr("- Length: the u16 at byte 2, high byte first, plus 6 bytes.\n"));
}

/// MIP: FA-F4 16-bit Fletcher sum; the length of byte 3 leaves out 4 bytes of header and 2 of sum.
TEST(DescriptionPage, OfAMipUnitSaysHowLongAPacketIs) {
  const auto page = description_page(*shipped("mip-imu.toml"));
  EXPECT_THAT(page, HasSubstr("- Length: the u8 at byte 3, plus 6 bytes.\n"));
  EXPECT_THAT(page, HasSubstr("- Checksum: fletcher-16, 2 bytes"));
}

class DescriptionPageOfFrames : public DbcFolder {};

TEST_F(DescriptionPageOfFrames, NamesIdentifierLengthCycleCounterAndChecksum) {
  const auto one = description(
      "depth",
      "BO_ 512 state: 6 s\n SG_ crc : 0|8@1+ (1,0) [0|0] \"\" s\n"
      " SG_ rolling : 8|4@1+ (1,0) [0|0] \"\" s\n"
      " SG_ pressure : 23|32@0- (1,0) [0|0] \"Pa\" s\n"
      "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\nBA_DEF_DEF_ \"GenMsgCycleTime\" 0;\n"
      "BA_ \"GenMsgCycleTime\" BO_ 512 20;\n",
      "[[protocol.frames]]\nmessage = \"state\"\ncounter = { signal = \"rolling\", modulus = 15 }\n"
      "checksum = { signal = \"crc\", kind = \"e2e-1-both\", data_id = 0x1234 }\n"
      "fields = [{ signal = \"pressure\", field = \"pressure_pa\" }]\n");
  const auto page = description_page(*one);
  EXPECT_THAT(page, HasSubstr("- Identifier 200h, 11 bits, 6 bytes, each 20 ms.\n"
                              "- Counter: signal rolling, modulo 15.\n"
                              "- Checksum: e2e-1-both in byte 0, identifier 1234h.\n\n| field |"));
  EXPECT_THAT(page, HasSubstr("| signal pressure | i32 from bit 23, Motorola | `pressure_pa` |"));
}

TEST(DescriptionPage, OfJ1939NamesGroupAndSender) {
  const auto page = description_page(*shipped("mv5-dbc.toml"));
  EXPECT_THAT(page, HasSubstr("29 bits: J1939, PGN 61482 of any sender, 8 bytes"));
}

}  // namespace description_page_test
}  // namespace drydock::described::test
