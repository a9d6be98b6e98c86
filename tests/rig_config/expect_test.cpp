#include "tests/rig_config/problems.hpp"

#include <algorithm>
#include <limits>

/// Blocks [[expect]]: names, figures, bounds.
namespace drydock::rig_config::test {
namespace expect_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string leveling =
    std::string(imu_table) +
    "[[estimator]]\nname = \"level\"\nkind = \"leveling\"\nimu = \"imu\"\nmodel = \"stationary\"\n";

std::vector<ExpectConfig> expects_of(const std::string& more) {
  const auto text = std::string(rig_table) + std::string(dvl_table) + more;
  return load_rig_text(text, "r.toml").value().expects;
}

TEST(Expect, AKeySaysWhichEndOfTheRangeItsNumberIs) {
  const auto expects = expects_of(
      "[[expect]]\ndevice = \"dvl\"\nafter_s = 5\nstate = \"streaming\"\nrate_hz = [4.9, 5.1]\n"
      "messages_min = 20\nreopens_max = 0\n");
  ASSERT_EQ(expects.size(), 1u);
  const ExpectConfig& e = expects[0];
  EXPECT_EQ(e.device, "dvl");
  EXPECT_EQ(e.estimator, "");
  EXPECT_EQ(e.after_s, 5);
  EXPECT_EQ(e.state, "streaming");
  EXPECT_EQ(e.state_line, 11);
  ASSERT_EQ(e.figures.size(), 3u);
  const auto figure = [&](const std::string& name) {
    return *std::ranges::find(e.figures, name, &ExpectedFigure::name);
  };
  EXPECT_EQ(figure("rate_hz").line, 12);
  EXPECT_TRUE(figure("rate_hz").allowed.hold(4.9));
  EXPECT_FALSE(figure("rate_hz").allowed.hold(5.2));
  EXPECT_TRUE(figure("messages").allowed.hold(1e6));
  EXPECT_FALSE(figure("messages").allowed.hold(19));
  EXPECT_FALSE(figure("reopens").allowed.hold(1));
  EXPECT_FALSE(figure("reopens").allowed.hold(std::numeric_limits<double>::quiet_NaN()));
}

TEST(Expect, AnUnknownNameIsToldTheKnownOnes) {
  EXPECT_THAT(problems_of("[[expect]]\ndevice = \"dvll\"\nreopens_max = 0\n"),
              ElementsAre("r.toml:9:10: /expect/0/device: no device is named \"dvll\" (did you "
                          "mean 'dvl'?), allowed: dvl"));
  EXPECT_THAT(problems_of("[[expect]]\nestimator = \"level\"\nestimates_min = 1\n"),
              ElementsAre("r.toml:9:13: /expect/0/estimator: no estimator is named \"level\", "
                          "this rig has no estimator"));
}

TEST(Expect, ABlockIsOfADeviceOrOfAnEstimator) {
  EXPECT_THAT(problems_of("[[expect]]\nstate = \"streaming\"\n"),
              ElementsAre("r.toml:8:1: /expect/0: key 'device' is missing"));
  EXPECT_THAT(
      problems_of(leveling +
                  "[[expect]]\nestimator = \"level\"\ndevice = \"dvl\"\nnees = [0, 2]\n"),
      ElementsAre(HasSubstr("/expect/0/device: not allowed here, only without 'estimator'")));
}

TEST(Expect, OnlyFindingsAreCountedForTheWholeRig) {
  const auto expects = expects_of("[[expect]]\nfindings_max = 0\n");
  ASSERT_EQ(expects.size(), 1u);
  EXPECT_EQ(expects[0].device + expects[0].estimator, "");
  EXPECT_EQ(expects[0].figures.at(0).name, "findings");
  EXPECT_FALSE(expects[0].figures.at(0).allowed.hold(1));
  EXPECT_THAT(
      problems_of("[[expect]]\nfindings_max = 0\nreopens_max = 0\n"),
      ElementsAre(HasSubstr("/expect/0/reopens_max: not allowed here, only with 'device'")));
  EXPECT_THAT(problems_of(leveling + "[[expect]]\nestimator = \"level\"\nfindings_max = 0\n"),
              ElementsAre(HasSubstr("/expect/0/findings_max: not allowed here")));
}

TEST(Expect, AFigureThatTheSubjectDoesNotHaveIsRefused) {
  EXPECT_THAT(problems_of("[[expect]]\ndevice = \"dvl\"\nnees = [0.5, 2]\n"),
              ElementsAre("r.toml:10:1: /expect/0/nees: not allowed here, only with 'estimator'"));
  EXPECT_THAT(problems_of(leveling + "[[expect]]\nestimator = \"level\"\nposition_rms_m_max = 3\n"),
              ElementsAre(HasSubstr(
                  "/expect/0/position_rms_m_max: estimator \"level\" is of kind leveling, "
                  "allowed: navigation, velocity")));
  EXPECT_THAT(problems_of(leveling + "[[expect]]\nestimator = \"level\"\nnis = [0.5, 2]\n"),
              IsEmpty());
}

TEST(Expect, EveryEstimatorWithAGateIsHeldToWhatItRefuses) {
  EXPECT_THAT(problems_of(leveling + "[[expect]]\nestimator = \"level\"\nrejected_max = 3\n"),
              IsEmpty());
}

TEST(Expect, ABlockWithoutAnythingToExpectIsRefused) {
  EXPECT_THAT(problems_of("[[expect]]\ndevice = \"dvl\"\nafter_s = 3\n"),
              ElementsAre(HasSubstr("r.toml:8:1: /expect/0: expects nothing")));
}

TEST(Expect, BoundsAreTwoNumbersTheLowerOneFirst) {
  EXPECT_THAT(problems_of("[[expect]]\ndevice = \"dvl\"\nrate_hz = [5.1, 4.9]\n"),
              ElementsAre("r.toml:10:11: /expect/0/rate_hz: no number is from 5.1 to 4.9: the "
                          "lower bound stands first"));
  EXPECT_THAT(problems_of("[[expect]]\ndevice = \"dvl\"\nrate_hz = 5\n"),
              ElementsAre(HasSubstr("/expect/0/rate_hz: expected an array, found an integer")));
  EXPECT_THAT(problems_of("[[expect]]\ndevice = \"dvl\"\nreopens_max = 0.5\n"),
              ElementsAre(HasSubstr("/expect/0/reopens_max: expected an integer")));
}

}  // namespace expect_test
}  // namespace drydock::rig_config::test
