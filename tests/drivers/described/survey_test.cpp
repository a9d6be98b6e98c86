#include "drivers/survey/byte_survey.hpp"

#include <gmock/gmock.h>

#include "tests/drivers/described/support.hpp"

/// Descriptions among the protocols of the registry, on a line that nobody knows.
namespace drydock::described::test {
namespace described_survey_test {

using survey::ByteSurvey;
using survey::Confidence;

survey::ByteFinding best_of(std::string_view line, const ByteSurvey::Descriptions& named,
                            const ByteSurvey::Descriptions& known) {
  ByteSurvey survey(named, known);
  for (int i = 1; i < 10; ++i)
    survey.feed(wire::testing::as_bytes(line), measurement::Stamp{} + std::chrono::seconds{i});
  survey.finish();
  return survey.best();
}

TEST(DescribedSurvey, ADescriptionIsFoundOnTheWireThatItDescribes) {
  const auto vat = shipped("valeport-vat.toml");
  ByteSurvey survey({vat, shipped("keller.toml")});
  const auto stream = wire::testing::fixture("described/valeport-vat.txt");
  for (int i = 0; i < 10; ++i) survey.feed(stream, measurement::stamp_from_ns(i * 1'000'000'000LL));
  const auto best = survey.best();
  EXPECT_EQ(best.protocol, "valeport-vat.toml");
  EXPECT_EQ(best.confidence, Confidence::certain);
  ASSERT_EQ(best.sensors.size(), 1u);
  EXPECT_EQ(best.sensors[0].kind, measurement::Kind::depth);
}

TEST(DescribedSurvey, ADescriptionOfTheProgramIsFoundWithoutBeingNamed) {
  const ByteSurvey::Descriptions known{shipped("nmea-depth.toml"), shipped("valeport-vat.toml")};
  const auto found = best_of("$PRVAT,00.115,M,0010.073,dBar*39\r\n", {}, known);
  EXPECT_EQ(found.protocol, "valeport-vat.toml");
  EXPECT_EQ(found.confidence, Confidence::certain);
  ASSERT_EQ(found.sensors.size(), 1u);
}

/// The registry reads HDT, the description DPT: both explain all bytes and half of the messages.
TEST(DescribedSurvey, AmongEqualsOneThatWasNamedIsFirstAndOneThatWasNotIsLast) {
  constexpr std::string_view line = "$INDPT,2.2,0.0*47\r\n$HEHDT,100.5,T*2B\r\n";
  const auto depth = shipped("nmea-depth.toml");
  EXPECT_EQ(best_of(line, {depth}, {}).protocol, "nmea-depth.toml");
  EXPECT_EQ(best_of(line, {}, {depth}).protocol, "nmea0183");
}

TEST(DescribedSurvey, ADescriptionOfTheProgramDoesNotTakeThePlaceOfACodec) {
  const auto heading = shipped("nmea-heading.toml");
  EXPECT_EQ(best_of("$HEHDT,100.5,T*2B\r\n", {}, {heading}).protocol, "nmea0183");
}

std::vector<std::string> sensors_on(std::string_view line, const ByteSurvey::Descriptions& known) {
  ByteSurvey survey({}, known);
  for (int i = 1; i < 10; ++i)
    survey.feed(wire::testing::as_bytes(line), measurement::Stamp{} + std::chrono::seconds{i});
  survey.finish();
  std::vector<std::string> sensors;
  for (const auto& sensor : survey::sensors_of(survey.findings()))
    sensors.push_back(std::string(to_string(sensor.kind)) + " " + std::string(sensor.protocol));
  return sensors;
}

/// The ordinary line of a ship: a receiver, a compass and a sounder behind one multiplexer. Most of
/// its sentences are the sounder's, so the description explains most.
TEST(DescribedSurvey, EveryKindOnALineIsASensorWhoeverReadsIt) {
  const ByteSurvey::Descriptions known{shipped("nmea-depth.toml"), shipped("nmea-heading.toml"),
                                       shipped("valeport-vat.toml")};
  constexpr std::string_view gps =
      "$GPGGA,100000.00,5321.6802,N,00630.3372,W,1,08,1.03,61.7,M,55.2,M,,*7E\r\n";
  constexpr std::string_view sounder =
      "$SDDBT,30.0,f,9.14,M,,F*27\r\n$SDDPT,9.14,0.5,200*70\r\n$YXMTW,12.5,C*14\r\n";
  const std::string line = std::string(gps) + std::string(sounder) + "$HEHDT,100.5,T*2B\r\n";
  EXPECT_THAT(
      sensors_on(line, known),
      testing::UnorderedElementsAre("gnss nmea0183", "attitude nmea0183", "depth nmea-depth.toml"));
}

/// Both are of kind depth, and each description passes over what the other one reads.
TEST(DescribedSurvey, TwoSensorsOfOneKindWithSentencesOfTheirOwnAreTwo) {
  const ByteSurvey::Descriptions known{shipped("nmea-depth.toml"), shipped("valeport-vat.toml")};
  EXPECT_THAT(sensors_on("$INDPT,2.2,0.0*47\r\n$PRVAT,00.115,M,0010.073,dBar*39\r\n", known),
              testing::UnorderedElementsAre("depth nmea-depth.toml", "depth valeport-vat.toml"));
}

/// The same sentences of one sensor are one sensor, although two protocols read them.
TEST(DescribedSurvey, OneSensorThatTwoProtocolsReadIsOne) {
  EXPECT_THAT(sensors_on("$HEHDT,100.5,T*2B\r\n", {shipped("nmea-heading.toml")}),
              testing::ElementsAre("attitude nmea0183"));
}

/// The sentences are those of the AIS of a ship (IEC 61993-2); the checksum is that of `$`.
TEST(DescribedSurvey, SentencesOfAisAreGoodFramesOfAnotherKind) {
  const auto found =
      best_of("!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C\r\n$INDPT,2.2,0.0*47\r\n", {},
              {shipped("nmea-depth.toml")});
  EXPECT_EQ(found.confidence, Confidence::certain);
  EXPECT_EQ(found.explained(), 1);
  ASSERT_EQ(found.unread.size(), 1u);
  EXPECT_EQ(found.unread[0].name, "!AIVDM");
  EXPECT_EQ(found.unread[0].count, 9u);
}

}  // namespace described_survey_test
}  // namespace drydock::described::test
