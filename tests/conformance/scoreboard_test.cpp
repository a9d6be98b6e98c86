#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>

#include "tests/conformance/report.hpp"
#include "tests/conformance/small_corpus.hpp"

/// The scoreboard must be able to fail: what it counts, and how it says it.
namespace drydock::conformance {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// From canboat's candumpSample3, with the values of its analyzer.
const std::string depth_frames =
    "(1502984866.422) can0 0DF50B74#00D0000000FFFFFF\n"
    "(1502984867.422) can0 0DF50B74#01D1000000FFFFFF\n";
const std::string first_depth =
    R"({"src":116,"pgn":128267,"fields":{"SID":0,"Depth":2.08,"Offset":-0.001}})"
    "\n";
const std::string second_depth =
    R"({"src":116,"pgn":128267,"fields":{"SID":1,"Depth":2.09,"Offset":-0.001}})"
    "\n";

TEST_F(Scoreboard, RightValuesAreMatched) {
  write("n2k/canboat/samples/log.txt", depth_frames);
  write("n2k/canboat/expected/log.txt.json", first_depth + second_depth);
  const Score score = only();
  EXPECT_TRUE(score.clean());
  EXPECT_EQ(score.counts().expected, 2u);
  EXPECT_EQ(score.counts().matched, 2u);
  EXPECT_EQ(score.counts().by_value, 2u);
  EXPECT_DOUBLE_EQ(score.fields().at("water_depth Depth").resolution, 0.01);
  EXPECT_LT(score.fields().at("water_depth Depth").largest, 1e-9);
}

TEST_F(Scoreboard, AWrongValueIsSeenWithItsPlaceAndBothReadings) {
  write("n2k/canboat/samples/log.txt", depth_frames);
  write("n2k/canboat/expected/log.txt.json",
        first_depth + R"({"src":116,"pgn":128267,"fields":{"SID":1,"Depth":2.1,"Offset":-0.001}})");
  const Score score = only();
  EXPECT_FALSE(score.clean());
  EXPECT_EQ(score.counts().wrong, 1u);
  EXPECT_EQ(score.counts().matched, 1u);
  ASSERT_THAT(score.differences(), SizeIs(1));
  const Difference& d = score.differences()[0];
  EXPECT_EQ(d.file, "log.txt");
  EXPECT_EQ(d.message, 2u);
  EXPECT_EQ(d.field, "water_depth Depth");
  EXPECT_EQ(d.ours, "2.09");
  EXPECT_EQ(d.theirs, "2.1");
  EXPECT_NEAR(score.fields().at("water_depth Depth").largest, 0.01, 1e-9);
}

TEST_F(Scoreboard, AValueWhereTheReferenceHasNoneIsWrong) {
  write("n2k/canboat/samples/log.txt", depth_frames);
  write("n2k/canboat/expected/log.txt.json",
        first_depth + R"({"src":116,"pgn":128267,"fields":{"SID":1,"Depth":2.09}})");
  EXPECT_EQ(only().counts().wrong, 1u);
}

TEST_F(Scoreboard, ARowWithoutFieldsIsAMessageWithoutValues) {
  write("n2k/canboat/samples/log.txt", "(1502984866.422) can0 0DF50B74#FFFFFFFFFFFF7FFF\n");
  write("n2k/canboat/expected/log.txt.json", R"({"src":116,"pgn":128267})");
  const Score score = only();
  EXPECT_TRUE(score.clean());
  EXPECT_EQ(score.counts().matched, 1u);
}

TEST_F(Scoreboard, ARowWithoutASenderIsAnErrorThatIsSaid) {
  write("n2k/canboat/samples/log.txt", depth_frames);
  write("n2k/canboat/expected/log.txt.json", R"({"pgn":128267,"fields":{"Depth":2.08}})");
  const Score score = only();
  EXPECT_FALSE(score.clean());
  ASSERT_THAT(score.errors(), SizeIs(1));
}

TEST_F(Scoreboard, AMissedMessageIsSeen) {
  write("n2k/canboat/samples/log.txt", depth_frames.substr(0, depth_frames.find('\n') + 1));
  write("n2k/canboat/expected/log.txt.json", first_depth + second_depth);
  const Score score = only();
  EXPECT_FALSE(score.clean());
  EXPECT_EQ(score.counts().missed, 1u);
  EXPECT_EQ(score.counts().wrong, 0u);
}

TEST_F(Scoreboard, AMessageThatTheReferenceDoesNotHaveIsWrong) {
  write("n2k/canboat/samples/log.txt", depth_frames);
  write("n2k/canboat/expected/log.txt.json", first_depth);
  const Score score = only();
  EXPECT_FALSE(score.clean());
  EXPECT_EQ(score.counts().wrong, 1u);
}

TEST_F(Scoreboard, CapturesWithoutExpectedValuesAreCountedAndSaid) {
  write("n2k/canboat/samples/log.txt", depth_frames);
  const Score score = only();
  EXPECT_TRUE(score.clean());
  EXPECT_EQ(score.counts().matched, 2u);
  EXPECT_EQ(score.counts().by_value, 0u);
  EXPECT_THAT(score.notes(), ElementsAre(HasSubstr("log.txt: no expected values")));
}

TEST_F(Scoreboard, ExpectedValuesWithoutTheirCaptureAreAnError) {
  write("n2k/canboat/expected/lost.txt.json", first_depth);
  const Score score = only();
  EXPECT_FALSE(score.clean());
  EXPECT_THAT(score.errors(), ElementsAre(HasSubstr("lost.txt.json")));
}

TEST_F(Scoreboard, UnreadableExpectedValuesAreAnErrorWithTheirLine) {
  write("n2k/canboat/samples/log.txt", depth_frames);
  write("n2k/canboat/expected/log.txt.json", first_depth + "{\"src\":116,\"pgn\":\n");
  const Score score = only();
  EXPECT_FALSE(score.clean());
  EXPECT_THAT(score.errors(), ElementsAre(HasSubstr("log.txt.json:2")));
}

TEST_F(Scoreboard, AFolderWithNothingKnownGivesNoCorpus) {
  write("notes/readme.txt", "nothing here");
  EXPECT_THAT(score_all(root_), IsEmpty());
}

TEST_F(Scoreboard, JsonAndTableSayWhatIsWrong) {
  write("n2k/canboat/samples/log.txt", depth_frames);
  write("n2k/canboat/expected/log.txt.json", first_depth);
  const auto results = score_all(root_);
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* out = open_memstream(&text, &size);
  print_json(results, out);
  std::fclose(out);
  const json printed = json::parse(std::string_view(text, size));
  std::free(text);
  EXPECT_EQ(printed["clean"], false);
  EXPECT_EQ(printed["corpora"][0]["corpus"], "n2k/canboat");
  EXPECT_EQ(printed["corpora"][0]["wrong"], 1);
  EXPECT_EQ(printed["corpora"][0]["differences"][0]["theirs"], "none");

  out = open_memstream(&text, &size);
  print_table(results, true, out);
  std::fclose(out);
  const std::string table(text, size);
  std::free(text);
  EXPECT_THAT(table, HasSubstr("WRONG    n2k/canboat: log.txt"));
  EXPECT_THAT(table, HasSubstr("NOT CLEAN"));
}

}  // namespace
}  // namespace drydock::conformance
