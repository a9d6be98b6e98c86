#include "drivers/diagnosis/finding_words.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "drivers/text/json_lines.hpp"

namespace drydock::diagnosis {
namespace finding_words_test {

using testing::HasSubstr;
using testing::StartsWith;

constexpr Stamp start{std::chrono::seconds{1000}};

constexpr Stamp after(double s) { return start + measurement::from_seconds(s); }

/// 12 damaged frames since 75.2 s of a run, known at 75.5 s.
Finding damaged() {
  Finding finding{.device = 0,
                  .cause = Cause::damaged,
                  .since = after(75.2),
                  .found = after(75.5),
                  .until = {},
                  .confidence = 0.9,
                  .evidence = {},
                  .advice = {}};
  finding.evidence.push_back({Sign::bad_checksums, 12, 0, "damaged frames in 1 s", ""});
  return finding;
}

TEST(FindingWords, AreOneLineWithDeviceCauseTimeEvidenceAndAdvice) {
  EXPECT_EQ(line_of(account_of(damaged(), "dvl", start)),
            "dvl: damaged since 75.2 s: 12 damaged frames in 1 s (at most 0) — look at the cable, "
            "its length and its ground; try a lower baud rate");
}

TEST(FindingWords, OfAFindingThatIsOverSayFromWhenToWhen) {
  Finding over = damaged();
  over.until = after(80.4);
  const auto account = account_of(over, "dvl", start);
  EXPECT_THAT(line_of(account), StartsWith("dvl: damaged from 75.2 s to 80.4 s: "));
  EXPECT_EQ(end_line_of(account), "dvl: no longer damaged after 5.2 s");
}

TEST(FindingWords, AMeasuredNumberStandsWithItsUnitAndItsLimitOnTheSideWhereItLies) {
  EXPECT_EQ(in_words({"wild samples", "yaw rate", 31, 12, "deg/s"}),
            "yaw rate 31 deg/s (at most 12 deg/s)");
  EXPECT_EQ(in_words({"rate too low", "rate", 2.5, 4.5, "Hz"}), "rate 2.5 Hz (at least 4.5 Hz)");
}

TEST(FindingWords, SeveralSignsAreAllTold) {
  Finding finding = damaged();
  finding.evidence.push_back({Sign::rate_low, 2.5, 4.5, "rate", "Hz"});
  EXPECT_THAT(line_of(account_of(finding, "dvl", start)),
              HasSubstr("(at most 0), rate 2.5 Hz (at least 4.5 Hz) — "));
}

TEST(FindingWords, TwoSignsOfOneNumberTellItOnce) {
  Finding finding = damaged();
  finding.evidence.clear();
  for (const Sign sign : {Sign::ramp, Sign::offset})
    finding.evidence.push_back({sign, 0.25, 0.07, "specific force ahead", "m/s2"});
  EXPECT_THAT(line_of(account_of(finding, "imu", start)),
              HasSubstr(": specific force ahead 0.25 m/s2 (at most 0.07 m/s2) — "));
}

TEST(FindingWords, AFindingWithoutEvidenceStillHasItsAdvice) {
  Finding finding = damaged();
  finding.evidence.clear();
  EXPECT_THAT(line_of(account_of(finding, "dvl", start)),
              StartsWith("dvl: damaged since 75.2 s — look at the cable"));
}

TEST(FindingWords, InJsonHaveKeysWithUnits) {
  text::JsonText text;
  text::JsonWriter(text).value(account_of(damaged(), "dvl", start));
  const auto json = nlohmann::json::parse(text.view());
  EXPECT_EQ(json["device"], "dvl");
  EXPECT_EQ(json["cause"], "damaged");
  EXPECT_EQ(json["severe"], false);
  EXPECT_DOUBLE_EQ(json["since_s"].get<double>(), 75.2);
  EXPECT_DOUBLE_EQ(json["found_s"].get<double>(), 75.5);
  EXPECT_TRUE(json["until_s"].is_null());
  EXPECT_DOUBLE_EQ(json["confidence"].get<double>(), 0.9);
  EXPECT_EQ(json["evidence"].dump(),
            R"([{"limit":0,"quantity":"damaged frames in 1 s","sign":"bad checksums",)"
            R"("unit":null,"value":12}])");
  EXPECT_EQ(json["meaning"], "frames arrive damaged");
  EXPECT_THAT(json["advice"].get<std::string>(), StartsWith("look at the cable"));
}

/// A person must be able to act on every cause.
TEST(FindingWords, EveryCauseHasOneWordAMeaningAndAdvice) {
  for (const CauseFacts& facts : causes()) {
    EXPECT_THAT(std::string(facts.name), testing::MatchesRegex("[a-z-]+"));
    EXPECT_FALSE(facts.meaning.empty()) << facts.name;
    EXPECT_FALSE(facts.advice.empty()) << facts.name;
  }
}

}  // namespace finding_words_test
}  // namespace drydock::diagnosis
