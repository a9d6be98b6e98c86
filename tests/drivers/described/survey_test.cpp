#include "drivers/survey/byte_survey.hpp"
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

}  // namespace described_survey_test
}  // namespace drydock::described::test
