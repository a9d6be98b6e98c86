#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numbers>

#include "drivers/wire/described/crc_line.hpp"
#include "tests/drivers/described/decoded.hpp"

/// Numbers as some sensors write them: two's complement in hexadecimal digits, signs that are
/// always there, commas before decimals, seven bits a byte; and checksums of no catalogue.
namespace drydock::described::test {
namespace forms_of_numbers_test {

using namespace wire::testing;
using ::testing::HasSubstr;
using wire::described::Decoded;
using wire::described::Record;

std::string with_protocol(const std::string& keys, const std::string& messages) {
  return "[sensor]\ntitle = \"toy\"\n[protocol]\n" + keys + messages;
}

/// The binary log BESTPOS, a log of the same receiver in ASCII, and their CRCs: NovAtel, "ASCII to
/// binary log conversion example".
const std::string bestpos_fields = R"(
[[protocol.binary]]
name = "bestpos"
sync = "AA 44 12"
length = { at = 8, type = "u16", plus = 32 }
fields = [
  { at = 4, type = "u16", is = 42 },
  { at = 36, type = "f64", name = "latitude_deg" },
  { at = 44, type = "f64", name = "longitude_deg" },
]
)";
constexpr const char* bestpos_hex =
    "AA44121C2A0000204800 00005EB40B0780ADA3010000 0000456183250000000020000000101186 5B58684040"
    "09A4CC35038141408F53742497EF33406666A2413D0000004FAF143D645D5C3DEFC9C33D3000 0000"
    "00004040000000001209090000000001C3EF64D2";

Buffer bytes_of(std::string_view hex) {
  Buffer bytes;
  std::string digits;
  for (const char c : hex)
    if (c != ' ') digits += c;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return bytes;
}

TEST(OwnCrc, OfAReceiverIsGivenByItsParametersOrByItsName) {
  for (const std::string sum :
       {"width=32 poly=0x04c11db7 init=0x0 refin=true refout=true xorout=0x0 check=0x2dfd2d88",
        "crc-32/novatel"}) {
    const auto bestpos = described(with_protocol("checksum = \"" + sum + "\"\n", bestpos_fields));
    const auto log = decoded(bestpos, bytes_of(bestpos_hex));
    EXPECT_NEAR(value_of(log, "latitude_deg"), 32.81519645735, 1e-11) << sum;
    EXPECT_NEAR(value_of(log, "longitude_deg"), 35.00791046612, 1e-11) << sum;
  }
}

TEST(OwnCrc, OfASentenceHasEightDigits) {
  const auto bestvel = described(with_protocol("checksum = \"crc-32/novatel\"\n", R"(
[[protocol.sentences]]
id = "#BESTVELA"
fields = [
  { skip = true }, { skip = true }, { skip = true }, { skip = true }, { skip = true },
  { name = "week_s", decimals = 3 }, { skip = true }, { skip = true }, { skip = true, ends = ";" },
  { type = "text", name = "solution" }, { skip = true }, { name = "latency_s" }, { skip = true },
  { name = "ground_speed_mps" }, { name = "course_deg" }, { name = "up_mps" }, { skip = true },
]
)"));
  // NovAtel, application note APN-067.
  const auto log = decoded(
      bestvel, as_bytes("#BESTVELA,COM1,0,46.0,FINESTEERING,1642,160721.000,00000020,827b,6302;"
                        "SOL_COMPUTED,DOPPLER_VELOCITY,0.150,0.000,0.0161,189.304443,-0.0042,0.0"
                        "*976f0082\r\n"));
  EXPECT_EQ(value_of(log, "ground_speed_mps"), 0.0161);
  EXPECT_EQ(value_of(log, "course_deg"), 189.304443);
}

TEST(OwnCrc, OfEveryEntryOfTheCatalogueIsThatOfItsName) {
  for (const auto& crc : wire::described::crcs) {
    const char* reflected = crc.reflected ? "true" : "false";
    const auto line = fmt::format(
        "width={} poly={:#x} init={:#x} refin={} refout={} xorout={:#x} check={:#x} name=\"{}\"",
        crc.width, crc.polynomial, crc.start, reflected, reflected, crc.xor_out, crc.check,
        crc.name);
    wire::described::Crc read;
    EXPECT_EQ(wire::described::read_crc(line, read), "") << line;
    EXPECT_EQ(read.polynomial, crc.polynomial);
  }
}

TEST(OwnCrc, WithAMistakeIsRefusedInWordsThatNameIt) {
  const std::string right = "width=16 poly=1021 init=FFFF refin=false refout=false xorout=0";
  const auto fault = [](const std::string& line) {
    wire::described::Crc crc;
    return wire::described::read_crc(line, crc);
  };
  EXPECT_EQ(fault(right + " check=29B1"), "");
  EXPECT_THAT(fault(right + " check=29B2"), HasSubstr("give 29B1 for 123456789, not check=29B2"));
  EXPECT_THAT(fault("width=16 poly=1021 init=FFFF refin=false xorout=0"), HasSubstr("refout= is"));
  EXPECT_THAT(fault("width=16 poly=11021 init=0 refin=false refout=false xorout=0"),
              HasSubstr("11021 has more than 16 bits"));
  EXPECT_THAT(fault("width=12 poly=80F init=0 refin=false refout=false xorout=0"),
              HasSubstr("8, 16, 24 or 32 bits"));
  EXPECT_THAT(fault("width=16 poly=1021 init=0 refin=true refout=false xorout=0"),
              HasSubstr("must be the same"));
  EXPECT_THAT(fault(right + " seed=1"), HasSubstr("\"seed\" is no parameter of a CRC"));
  EXPECT_THAT(fault(right + " reflected"), HasSubstr("\"reflected\" is no parameter of a CRC"));
  EXPECT_THAT(fault("width=16 poly= init=0 refin=no refout=no xorout=0"),
              HasSubstr("poly has no value"));
  EXPECT_THAT(problems_of(with_protocol("checksum = \"width=16\"\n", bestpos_fields)),
              HasSubstr("toy.toml:4:12: /protocol/checksum: poly= is missing"));
}

/// TSS1, the string of motion sensors: sideways acceleration in 3.83 cm/s2, vertical in .0625 cm/s2
/// in two's complement, heave in cm, roll and pitch in .01 deg with a blank for plus.
const std::string tss1 = R"(
[sensor]
title = "Motion sensor, TSS1"
kind = "attitude"
[protocol]
[[protocol.lines]]
name = "tss1"
head = ":"
pattern = '(?P<sideways>[0-9A-F]{2})(?P<vertical>[0-9A-F]{4})(?P<heave>[ -][0-9]{4})(?P<status>[UuGgHhFf])(?P<roll>[ -][0-9]{4}) (?P<pitch>[ -][0-9]{4})'
emulate = "00{vertical} 0000F{roll} {pitch}"
fields = [
  { group = "sideways", type = "hex", name = "sideways_cmps2", scale = 3.83, width = 2 },
  { group = "vertical", type = "hex_signed", name = "vertical_cmps2", scale = 0.0625, width = 4, emulate = -2 },
  { group = "heave", name = "heave_cm" },
  { group = "status", type = "text", name = "status" },
  { group = "roll", field = "roll_deg", unit = "deg", scale = 0.01, decimals = 0, width = 5, sign = " " },
  { group = "pitch", field = "pitch_deg", unit = "deg", scale = 0.01, decimals = 0, width = 5, sign = " " },
]
)";

TEST(SignedHex, IsTwosComplementOfItsDigits) {
  const auto description = described(tss1);
  const auto down = decoded(description, as_bytes(":1AFFFE-0005F 0123 -0456\r\n"));
  EXPECT_NEAR(value_of(down, "vertical_cmps2"), -2 * 0.0625, 1e-12);
  EXPECT_NEAR(value_of(down, "sideways_cmps2"), 26 * 3.83, 1e-12);
  EXPECT_EQ(value_of(down, "heave_cm"), -5);
  EXPECT_NEAR(value_of(down, "roll_deg"), 1.23, 1e-12);
  EXPECT_NEAR(value_of(down, "pitch_deg"), -4.56, 1e-12);
  const auto up = decoded(description, as_bytes(":000010 0005F-0123  0456\r\n"));
  EXPECT_NEAR(value_of(up, "vertical_cmps2"), 1, 1e-12);
  EXPECT_NEAR(value_of(up, "pitch_deg"), 4.56, 1e-12);
}

TEST(SignedHex, NeedsItsDigits) {
  std::string text = tss1;
  text.replace(text.find("scale = 0.0625, width = 4"), 25, "scale = 0.0625");
  EXPECT_THAT(problems_of(text), HasSubstr("has a 'width', its 1 to 16 digits"));
}

/// As the driver of another program would look at the line of the emulated sensor.
TEST(SignOfANumber, StandsBeforeWhatIsNotNegativeToo) {
  const auto description = described(tss1);
  wire::described::Readings readings;
  constexpr double degree = std::numbers::pi / 180;
  readings.set(wire::described::Target::roll, 1.23 * degree);
  readings.set(wire::described::Target::pitch, -4.56 * degree);
  Buffer bytes(256);
  const auto size =
      wire::described::encode(description->plan, description->plan.messages[0], readings, bytes);
  EXPECT_EQ(as_text(wire::Bytes(bytes).first(size)), ":00FFFE 0000F 0123 -0456\r\n");
}

const std::string comma = with_protocol("separator = \";\"\ndecimal = \",\"\n", R"(
[[protocol.lines]]
name = "depth"
head = "D;"
fields = [{ name = "depth_m", decimals = 2, emulate = 3.25 }, { name = "celsius" }, { text = "OK" }]
)");

TEST(DecimalComma, IsReadAndWritten) {
  const auto description = described(comma);
  const auto line = decoded(description, as_bytes("D;-12,07;8;OK\r\n"));
  EXPECT_EQ(value_of(line, "depth_m"), -12.07);
  EXPECT_EQ(value_of(line, "celsius"), 8);
  Buffer bytes(256);
  const auto size =
      wire::described::encode(description->plan, description->plan.messages[0], {}, bytes);
  EXPECT_EQ(as_text(wire::Bytes(bytes).first(size)), "D;3,25;0,000;OK\r\n");
}

TEST(DecimalComma, RefusesAPointBecauseItsMeaningIsNotKnown) {
  const auto description = described(comma);
  Record record;
  EXPECT_NE(wire::described::decode(description->plan, as_bytes("D;1.207,5;8;OK\r\n"), record),
            Decoded::message);
}

TEST(EmulatedLine, ThatIsNotItsMessageIsRefusedAndShown) {
  std::string text = tss1;
  text.replace(text.find("emulate = \"00{"), 14, "emulate = \":00{");
  EXPECT_THAT(problems_of(text),
              HasSubstr("/protocol/lines/0/emulate: the emulated device would write \"::00FFFE"));
  text = tss1;
  text.replace(text.find("width = 5, sign = \" \""), 21, "width = 5");
  EXPECT_THAT(problems_of(text), HasSubstr("a field may need 'decimals', 'width' or 'sign'"));
}

TEST(Brackets, ThatBeginNoGroupAreWrittenTwice) {
  const auto description = described(with_protocol("", R"(
[[protocol.lines]]
name = "json"
head = '{"depth":'
pattern = '(?P<depth>[0-9.]+),"more":\{"volt":12\}\}'
emulate = '{depth},"more":{{"volt":12}}'
fields = [{ group = "depth", decimals = 2, emulate = 1.5 }]
)"));
  Buffer bytes(256);
  bytes.resize(
      wire::described::encode(description->plan, description->plan.messages[0], {}, bytes));
  EXPECT_EQ(as_text(bytes), "{\"depth\":1.50,\"more\":{\"volt\":12}}\r\n");
  EXPECT_EQ(value_of(decoded(description, bytes), "depth"), 1.5);
}

TEST(DecimalComma, NeedsAnotherSeparatorAndAText) {
  std::string text = comma;
  text.replace(text.find("separator = \";\"\n"), 16, "");
  EXPECT_THAT(problems_of(text), HasSubstr("is the separator too; allowed: separator = another"));
  EXPECT_THAT(problems_of(with_protocol("decimal = \",\"\n", bestpos_fields)),
              HasSubstr("only numbers of a text have it"));
}

/// The profile range of an Imagenex 852: seven bits in each of two bytes, the low one first.
TEST(Septets, AreSevenBitsOfEachByte) {
  const std::string message = R"(
[[protocol.binary]]
name = "profile"
sync = "49 50 58"
length = 7
fields = [{ at = 3, type = "septet2", name = "range_cm", emulate = 1234 },
          { at = 5, type = "septet2", order = "big", name = "other", emulate = 16383 }]
)";
  const auto description = described(with_protocol("", message));
  const Buffer frame{0x49, 0x50, 0x58, 0x52, 0x09, 0x7F, 0x7F};  // 9 * 128 + 82
  EXPECT_EQ(value_of(decoded(description, frame), "range_cm"), 1234);
  EXPECT_EQ(value_of(decoded(description, frame), "other"), 16383);
  Buffer bytes(16);
  const auto size =
      wire::described::encode(description->plan, description->plan.messages[0], {}, bytes);
  bytes.resize(size);
  EXPECT_EQ(bytes, frame);
}

}  // namespace forms_of_numbers_test
}  // namespace drydock::described::test
