#include "tests/drivers/described/decoded.hpp"

/// What the shipped descriptions read and write, against the documents.
namespace drydock::described::test {
namespace values_test {

using namespace wire::testing;
using wire::described::Record;

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

/// Channels 2 and 4 with their values, then with the status bits 20h (TOB2) and 90h (TOB1, unit).
TEST(DescribedValues, AKellersOtherChannelsAreReadAndTheirFailuresRefused) {
  struct Channel {
    const char *file, *golden, *key;
    double value;
  };
  for (const Channel& one :
       {Channel{"keller-p2.toml", "keller-p2.bin", "pressure_pa", 75'000},
        Channel{"keller-tob1.toml", "keller-tob1.bin", "temperature_k", 271.65}}) {
    const wire::described::DescribedCodec codec(shipped(one.file));
    const Buffer golden = fixture(std::string("described/") + one.golden);
    std::vector<bool> valid;
    wire::Framer<1024> framer;
    framer.feed(
        golden, [&](wire::Bytes b) { return codec.scan(b); },
        [&](wire::Bytes frame, std::size_t) {
          const auto record = std::get<Record>(codec.decode(frame).value());
          if (record.type == "request") return;
          EXPECT_NEAR(value_of(record, one.key), one.value, 1e-6) << one.file;
          valid.push_back(record.valid);
        });
    EXPECT_EQ(valid, (std::vector{true, false})) << one.file;
  }
}

/// RMC of a receiver that has the time, and no fix: NMEA 0183 says so with V.
TEST(DescribedValues, AReceiverThatKnowsOnlyTheTimeSaysThatItHasNoFix) {
  const auto rmc = described(R"(
[sensor]
title = "RMC"
kind = "gnss"
[protocol]
[[protocol.sentences]]
id = "$GPRMC"
fields = [
  { field = "utc_s", unit = "hhmmss" },
  { field = "valid", type = "text", good = ["A"], bad = "V" },
  { field = "latitude_deg", unit = "ddmm" },
  { sign_of = "latitude_deg", plus = "N", minus = "S" },
  { field = "longitude_deg", unit = "ddmm" },
  { sign_of = "longitude_deg", plus = "E", minus = "W" },
  { field = "date_s", unit = "ddmmyy" },
]
)");
  wire::described::Readings readings;
  readings.set(wire::described::Target::utc, 45'296);
  readings.set(wire::described::Target::date, 0);
  std::array<std::uint8_t, 128> line;
  const auto size = encode(rmc->plan, rmc->plan.messages[0], readings, line);
  const auto said = as_text(wire::Bytes(line).first(size));
  EXPECT_TRUE(said.starts_with("$GPRMC,123456.000,V,,,,,010170*")) << said;
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

}  // namespace values_test
}  // namespace drydock::described::test
