#include <fstream>

#include "drivers/wire/dvl/nortek.hpp"
#include "drivers/wire/dvl/water_linked.hpp"
#include "tests/drivers/described/support.hpp"

/// What the descriptions read, against the documents and against the codecs written by hand.
namespace drydock::described::test {
namespace {

using namespace wire::testing;
using wire::described::Decoded;
using wire::described::Record;

Record decoded(const DescriptionPtr& description, std::string_view line) {
  Record record;
  const Buffer frame = as_bytes(line);
  const auto scan = wire::described::scan(description->plan, frame);
  EXPECT_EQ(scan, wire::Scan::frame(frame.size())) << line;
  EXPECT_EQ(wire::described::decode(description->plan, frame, record), Decoded::message) << line;
  return record;
}

TEST(DescribedValues, ChecksumsOfNineDigitsAreThoseOfTheCatalogue) {
  const Buffer digits = as_bytes("123456789");
  for (const auto& crc : wire::described::crcs) {
    wire::described::Checksum checksum;
    ASSERT_TRUE(wire::described::Checksum::find(crc.name, checksum));
    EXPECT_EQ(checksum.of(digits), crc.check) << crc.name;
  }
  // Sums by hand: the digits are 49 to 57.
  for (const auto& [name, sum] :
       {std::pair("sum-8", 0xDDu), std::pair("sum-16", 0x1DDu), std::pair("sum-32", 0x1DDu),
        std::pair("xor", 0x31u), std::pair("fletcher-16", 0x15DDu),
        std::pair("fletcher-16-255", 0x1EDEu), std::pair("sum-8-inverted", 0x22u),
        std::pair("word-sum-16", 0xD509u), std::pair("word-sum-16-big", 0x09D4u),
        std::pair("sum-16-negative", 0xFE23u), std::pair("sum-32-inverted", 0xFFFFFE22u),
        std::pair("word-sum-16-negative", 0x2AF7u),
        std::pair("word-sum-16-big-inverted", 0xF62Bu)}) {
    wire::described::Checksum checksum;
    ASSERT_TRUE(wire::described::Checksum::find(name, checksum));
    EXPECT_EQ(checksum.of(digits), sum) << name;
  }
}

TEST(DescribedValues, AnotherNameOfTheCatalogueIsTheSameChecksumInCapitalsOrNot) {
  const Buffer digits = as_bytes("123456789");
  for (const auto& [name, check] :
       {std::pair("crc-16/ccitt-false", 0x29B1u), std::pair("CRC-16/X-25", 0x906Eu),
        std::pair("CRC-32", 0xCBF43926u), std::pair("crc-32c", 0xE3069283u),
        std::pair("CRC-8", 0xF4u), std::pair("Modbus", 0x4B37u)}) {
    wire::described::Checksum checksum;
    ASSERT_TRUE(wire::described::Checksum::find(name, checksum)) << name;
    EXPECT_EQ(checksum.of(digits), check) << name;
  }
  for (const auto& alias : wire::described::crc_aliases) {
    wire::described::Checksum checksum;
    ASSERT_TRUE(wire::described::Checksum::find(alias.alias, checksum)) << alias.alias;
    EXPECT_EQ(checksum.name(), alias.name);
  }
}

TEST(DescribedValues, ValeportGivesHeightAndPressureOrDepthByItsUnitWord) {
  const auto vat = shipped("valeport-vat.toml");
  const auto pressure = decoded(vat, "$PRVAT,00.115,M,0010.073,dBar*39\r\n");
  EXPECT_EQ(pressure.type, "PRVAT");
  EXPECT_DOUBLE_EQ(value_of(pressure, "altitude_m"), 0.115);
  EXPECT_DOUBLE_EQ(value_of(pressure, "pressure_pa"), 100'730);
  const auto depth = decoded(vat, "$PRVAT,00.210,M,0007.497,Metres*3a\r\n");
  EXPECT_EQ(depth.type, "PRVAT_depth");
  EXPECT_DOUBLE_EQ(value_of(depth, "depth_m"), 7.497);
  const auto no_echo = decoded(vat, "$PRVAT,00.000,M,0012.500,dBar*3f\r\n");
  EXPECT_TRUE(std::isnan(value_of(no_echo, "altitude_m")));
}

TEST(DescribedValues, ASounderGivesItsHeightInTheUnitThatItFills) {
  const auto sounder = shipped("nmea-depth.toml");
  wire::described::Readings readings;
  const auto altitude = [&](std::string_view line) {
    const auto record = decoded(sounder, line);
    read(record, readings);
    return readings.get(wire::described::Target::altitude);
  };
  EXPECT_DOUBLE_EQ(altitude("$SDDBT,7.7,f,2.3,M,1.3,F*05\r\n").value(), 2.3);
  EXPECT_DOUBLE_EQ(altitude("$SDDBT,10.0,f,,M,,F*37\r\n").value(), 3.048);
  EXPECT_DOUBLE_EQ(altitude("$INDPT,2.2,0.0*47\r\n").value(), 2.2);
  EXPECT_FALSE(altitude("$SDDPT,,,*7B\r\n"));
  const auto navico = decoded(sounder, "$SDDPT,24.6,-1.-1,*4B\r\n");
  EXPECT_DOUBLE_EQ(value_of(navico, "altitude_m"), 24.6);
  EXPECT_TRUE(std::isnan(value_of(navico, "offset_m")));
  EXPECT_EQ(navico.malformed, 0b10u) << "the second field is no number, and that is told";
  EXPECT_DOUBLE_EQ(value_of(decoded(sounder, "$SDMTW,12.5,C*02\r\n"), "temperature_k"), 285.65);
}

TEST(DescribedValues, CeruleanGivesDistanceOverTimeAndNothingWithoutConfidence) {
  const auto dvpdl = shipped("cerulean-dvpdl.toml");
  wire::described::Readings readings;
  const auto record = decoded(
      dvpdl, "$DVPDL,1398604000,50000,0.000000,-0.000000,-0.000000,-0.003,0.017,0.002,100*79\r\n");
  read(record, readings);
  EXPECT_NEAR(*readings.get(wire::described::Target::forward), -0.06, 1e-12);  // -0.003 m in 0.05 s
  EXPECT_NEAR(*readings.get(wire::described::Target::starboard), 0.34, 1e-12);
  EXPECT_NEAR(*readings.get(wire::described::Target::down), 0.04, 1e-12);
  EXPECT_DOUBLE_EQ(*readings.get(wire::described::Target::time), 1398.604);
  read(decoded(dvpdl,
               "$DVPDL,1398654000,50000,0.000000,-0.000000,-0.000000,9.000,9.000,9.000,0*5E\r\n"),
       readings);
  EXPECT_FALSE(readings.measured());
}

TEST(DescribedValues, DigiquartzGivesAbsolutePressureFromPsi) {
  const auto digiquartz = shipped("digiquartz.toml");
  const auto record = decoded(digiquartz, "*000114.6959494\r\n");
  EXPECT_NEAR(value_of(record, "pressure_pa"), 101'325.0, 0.01);  // one atmosphere is 14.6959 psi
}

TEST(DescribedValues, ADigiquartzMayPutItsTimeInFrontOrItsTemperatureBehind) {
  const auto digiquartz = shipped("digiquartz.toml");
  const auto stamped = decoded(digiquartz, "*0001,07/04/26 12:00:00.000,14.6959494\r\n");
  EXPECT_NEAR(value_of(stamped, "pressure_pa"), 101'325.0, 0.01);
  const auto both = decoded(digiquartz, "*0001,14.6959494,21.5\r\n");
  EXPECT_NEAR(value_of(both, "pressure_pa"), 101'325.0, 0.01);
  EXPECT_EQ(value_of(both, "temperature"), 21.5);
}

TEST(DescribedValues, KellerGivesBarsAndRefusesAFailedChannel) {
  using P = wire::described::DescribedCodec;
  const P keller(shipped("keller.toml"));
  std::vector<double> pressures;
  std::vector<bool> valid;
  wire::Framer<1024> framer;
  const Buffer golden = fixture("described/keller.bin");
  framer.feed(
      golden, [&](wire::Bytes b) { return keller.scan(b); },
      [&](wire::Bytes frame, std::size_t) {
        const auto message = keller.decode(frame);
        ASSERT_TRUE(message);
        const auto& record = std::get<Record>(*message);
        if (record.type != "pressure") return;
        pressures.push_back(value_of(record, "pressure_pa"));
        valid.push_back(record.valid);
      });
  ASSERT_EQ(pressures.size(), 2u);
  EXPECT_NEAR(pressures[0], 101'325, 0.01);
  EXPECT_EQ(valid, (std::vector{true, false}));
}

/// Lines of a corpus file that begin with a word, without their notes.
std::vector<std::string> corpus_lines(const std::string& file, std::string_view word, char mark) {
  std::vector<std::string> lines;
  std::ifstream in(corpora() / file);
  for (std::string line; std::getline(in, line);) {
    const auto at = line.find(mark == '$' ? "$" : "\twr");
    if (!line.starts_with(word) || at == line.npos) continue;
    std::string sentence = line.substr(mark == '$' ? at : at + 1);
    lines.push_back(sentence.substr(0, sentence.rfind('*') + 3) + "\r\n");
  }
  return lines;
}

std::optional<double> in_seconds(const std::optional<std::chrono::microseconds>& t) {
  return t ? std::optional(std::chrono::duration<double>(*t).count()) : std::nullopt;
}

void expect_same(const Record& record, std::string_view key,
                 const std::optional<double>& expected) {
  const double value = value_of(record, key);
  EXPECT_EQ(!std::isnan(value), expected.has_value()) << key;
  if (expected) {
    EXPECT_DOUBLE_EQ(value, *expected) << key;
  }
}

TEST(DescribedValues, WaterLinkedsSentencesReadAsWithTheCodecWrittenByHand) {
  if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no corpora";
  const auto wrz = shipped("water-linked-wrz.toml");
  std::size_t compared = 0;
  for (const auto& line : corpus_lines("dvl/waterlinked/wl_serial_vectors.txt", "crc_ok", 'w')) {
    const auto by_hand = wire::WaterLinked::decode(as_bytes(line));
    ASSERT_TRUE(by_hand);
    if (const auto* m = std::get_if<wire::water_linked::BottomVelocity>(&*by_hand)) {
      const Record record = decoded(wrz, line);
      expect_same(record, "forward_mps", m->velocity_mps[0]);
      expect_same(record, "starboard_mps", m->velocity_mps[1]);
      expect_same(record, "down_mps", m->velocity_mps[2]);
      expect_same(record, "altitude_m", m->altitude_m);
      expect_same(record, "figure_of_merit_mps", m->figure_of_merit_mps);
      expect_same(record, "covariance_xx_m2ps2", m->covariance[0]);
      expect_same(record, "covariance_xz_m2ps2", m->covariance[2]);
      expect_same(record, "covariance_zz_m2ps2", m->covariance[8]);
      expect_same(record, "valid_at_s", in_seconds(m->validity));
      expect_same(record, "sent_at_s", in_seconds(m->transmission));
      expect_same(record, "interval_s", m->interval_s);
      EXPECT_EQ(record.valid, m->valid);
      ++compared;
    }
    if (const auto* m = std::get_if<wire::water_linked::Transducer>(&*by_hand)) {
      const Record record = decoded(wrz, line);
      expect_same(record, "velocity_mps", m->velocity_mps);
      expect_same(record, "distance_m", m->distance_m);
      expect_same(record, "rssi_dbm", m->rssi_dbm);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 6u) << "one wrz and five wru have a right checksum";
}

TEST(DescribedValues, NorteksSentencesReadAsWithTheCodecWrittenByHand) {
  if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no corpora";
  const auto nortek = shipped("nortek-bt.toml");
  std::size_t compared = 0;
  for (const auto& line : corpus_lines("dvl/nortek/pnor_sentences.txt", "ok $PNORBT", '$')) {
    const auto by_hand = wire::Nortek::decode(as_bytes(line));
    const auto* m = by_hand ? std::get_if<wire::NortekVelocity>(&*by_hand) : nullptr;
    if (!m) continue;
    const Record record = decoded(nortek, line);
    expect_same(record, "time_s", m->ping_time_s);
    expect_same(record, "age_s", -*m->after_sentence_s);
    expect_same(record, "forward_mps", m->velocity_mps[0]);
    expect_same(record, "down_mps", m->velocity_mps[2]);
    expect_same(record, "figure_of_merit_mps", m->figure_of_merit_mps);
    expect_same(record, "range_1_m", m->distance_m[0]);
    expect_same(record, "range_4_m", m->distance_m[3]);
    if (record.type == "PNORBT9") expect_same(record, "sound_speed_mps", m->sound_speed_mps);
    ++compared;
  }
  EXPECT_EQ(compared, 2u);
}

TEST(DescribedValues, EncodedMessagesReadBackToHalfALastDigit) {
  using enum wire::described::Target;
  const auto vat = shipped("valeport-vat.toml");
  wire::described::Readings sent, got;
  sent.set(altitude, 12.3456);
  sent.set(pressure, 234'567.0);
  std::array<std::uint8_t, 256> bytes{};
  const auto size = encode(vat->plan, vat->plan.messages[0], sent, bytes);
  // XOR by hand of the text between $ and *.
  EXPECT_TRUE(
      as_text(wire::Bytes(bytes).first(size)).starts_with("$PRVAT,12.346,M,0023.457,dBar*"));
  read(decoded(vat, as_text(wire::Bytes(bytes).first(size))), got);
  EXPECT_NEAR(*got.get(altitude), 12.3456, 0.5e-3);
  EXPECT_NEAR(*got.get(pressure), 234'567, 0.5e-3 * 1e4);
}

/// Microseconds since 1970 have 16 digits.
TEST(DescribedValues, ATimeOfDayInMicrosecondsIsWrittenWhole) {
  using enum wire::described::Target;
  const auto dvl = shipped("cerulean-dvpdl.toml");
  wire::described::Readings sent;
  sent.set(time, 1'763'712'000.5);
  sent.set(interval, 0.1);
  std::array<std::uint8_t, 256> bytes{};
  const auto size = encode(dvl->plan, dvl->plan.messages[0], sent, bytes);
  const auto line = as_text(wire::Bytes(bytes).first(size));
  EXPECT_TRUE(line.starts_with("$DVPDL,1763712000500000,100000,")) << line;
}

constexpr std::string_view toy_frame = R"(
[sensor]
title = "toy"
kind = "imu"
[protocol]
checksum = "sum-16"
[[protocol.binary]]
name = "sample"
sync = "A5 5A"
length = {at = 2, type = "u8", plus = 3}
fields = [
  {at = 3, type = "i16", field = "force_x_mps2", unit = "mg", no_value = [-32768]},
  {at = 5, type = "i16", field = "force_y_mps2", unit = "mg", order = "big"},
  {at = 7, type = "i24", field = "force_z_mps2", unit = "mg"},
  {at = 10, type = "u32", bits = [4, 12], field = "rate_x_degps", unit = "deg/s", scale = 0.1, offset = -200},
  {at = 14, type = "bcd2", field = "rate_y_degps", unit = "deg/s", order = "big"},
  {at = 16, type = "f64", field = "rate_z_degps", unit = "rad/s"},
])";

TEST(DescribedValues, BinaryFieldsHaveTheirSizeOrderBitsDigitsAndScale) {
  const auto toy = described(toy_frame);
  // By hand: -1000, 1000 (big), -2 (24 bits), 2345 in bits 4 to 15, digits 1234, 0.5 as a double.
  Buffer frame{0xA5, 0x5A, 23,   0x18, 0xFC, 0x03, 0xE8, 0xFE, 0xFF, 0xFF, 0x9F, 0x92,
               0xFF, 0xFF, 0x12, 0x34, 0,    0,    0,    0,    0,    0,    0xE0, 0x3F};
  unsigned sum = 0;
  for (const auto byte : frame) sum += byte;
  frame.push_back(static_cast<std::uint8_t>(sum));
  frame.push_back(static_cast<std::uint8_t>(sum >> 8));
  const auto record = decoded(toy, as_text(frame));
  EXPECT_DOUBLE_EQ(value_of(record, "force_x_mps2"), -9.80665);
  EXPECT_DOUBLE_EQ(value_of(record, "force_y_mps2"), 9.80665);
  EXPECT_DOUBLE_EQ(value_of(record, "force_z_mps2"), -0.0196133);
  EXPECT_NEAR(value_of(record, "rate_x_degps"), 34.5, 1e-9);  // 0x929 = 2345
  EXPECT_NEAR(value_of(record, "rate_y_degps"), 1234, 1e-9);
  EXPECT_NEAR(value_of(record, "rate_z_degps"), 28.64788975654116, 1e-12);  // 0.5 rad/s
}

TEST(DescribedValues, BinaryMessagesOfAnyContentReadBackWithinAStep) {
  using enum wire::described::Target;
  const auto toy = described(toy_frame);
  wire::described::Readings sent, got;
  for (const double x : {-30.0, -0.01, 0.0, 5.4321, 300.0}) {
    for (int i = 0; i < 6; ++i)
      sent.set(static_cast<wire::described::Target>(static_cast<int>(force_x) + i), x / 10);
    std::array<std::uint8_t, 64> bytes{};
    const auto size = encode(toy->plan, toy->plan.messages[0], sent, bytes);
    ASSERT_EQ(size, 26u);
    read(decoded(toy, as_text(wire::Bytes(bytes).first(size))), got);
    EXPECT_NEAR(*got.get(force_x), x / 10, 0.5 * 9.80665e-3);
    EXPECT_NEAR(*got.get(force_z), x / 10, 0.5 * 9.80665e-3);
    EXPECT_DOUBLE_EQ(*got.get(rate_z), x / 10);
  }
}

}  // namespace
}  // namespace drydock::described::test
