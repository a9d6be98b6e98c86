// A scorecard as a file that serves as its own reference, and as a picture.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "hil/scorecard/heat_map.hpp"
#include "hil/scorecard/scorecard_file.hpp"

namespace scorecard_file_test {

using namespace drydock;
using namespace drydock::scorecard;

Scorecard card_of(Score s) {
  Scorecard card;
  card.rig = "hand-made";
  card.pairs = 1;
  card.scores = {std::move(s)};
  return card;
}

Score one_score() {
  Score s;
  s.device = "depth";
  s.fault = "flip";
  s.detect_s = 0.12345;
  s.recover_s = 1.5;
  s.wrong = 2;
  return s;
}

TEST(ScorecardFile, IsALineAPairAndItsOwnReference) {
  const auto text = to_json_text(card_of(one_score()));
  EXPECT_NE(text.find("\n{\"device\":\"depth\",\"fault\":\"flip\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"detect_s\":0.123,"), std::string::npos) << text;
  EXPECT_TRUE(differences_from(text, card_of(one_score())).empty());
}

TEST(ScorecardFile, EveryFigureThatIsNotTheSameIsALine) {
  const auto text = to_json_text(card_of(one_score()));
  Score worse = one_score();
  worse.wrong = 3;
  worse.recover_s.reset();
  EXPECT_EQ(differences_from(text, card_of(worse)),
            (std::vector<std::string>{"depth flip: recover_s: expected 1.5, got null",
                                      "depth flip: wrong: expected 2, got 3"}));
  Score other = one_score();
  other.fault = "drop";
  EXPECT_EQ(differences_from(text, card_of(other)),
            (std::vector<std::string>{"depth drop: not in the reference",
                                      "depth flip: only in the reference"}));
}

TEST(ScorecardFile, AReferenceOfAnotherSeedIsRefusedInALine) {
  const auto text = to_json_text(card_of(one_score()));
  auto card = card_of(one_score());
  card.seed = 7;
  EXPECT_THROW(differences_from(text, card), std::runtime_error);
  EXPECT_THROW(differences_from("[]", card), std::runtime_error);
  EXPECT_THROW(differences_from("{\"drydock_scorecard\":1}", card), std::runtime_error);
}

TEST(HeatMap, EveryCellHasItsNumberAndTextIsEscaped) {
  HeatMap map{
      "a<b",
      {{"p", {"x", "y"}}},
      {{"layer", {}}, {"row", {{"1.5", Tone::shade, 1, ""}, {"not", Tone::alarm, 0, "why & how"}}}},
      40};
  const auto svg = to_svg(map);
  EXPECT_NE(svg.find("a&lt;b"), std::string::npos);
  EXPECT_NE(svg.find(">1.5</text>"), std::string::npos);
  EXPECT_NE(svg.find("why &amp; how"), std::string::npos);
  EXPECT_NE(svg.find("#084081"), std::string::npos) << "the darkest shade";
}

TEST(HeatMap, ATitleWiderThanItsColumnsPushesTheNextAside) {
  const HeatMap map{"one device",
                    {{"seen after [s]", {"dvl"}}, {"over after [s]", {"dvl"}}},
                    {{"drop", {{"1", Tone::shade, 0, ""}, {"2", Tone::shade, 0, ""}}}},
                    40};
  const auto svg = to_svg(map);
  EXPECT_NE(svg.find("x='170' y='38' font-weight='600'>seen after [s]<"), std::string::npos);
  EXPECT_NE(svg.find("x='287' y='38' font-weight='600'>over after [s]<"), std::string::npos);
}

}  // namespace scorecard_file_test
