#include "rig_config/toml/with_estimator.hpp"

#include <gmock/gmock.h>

#include "rig_config/load.hpp"
#include "rig_config/toml/split_values.hpp"

namespace with_estimator_test {

using namespace drydock;
using namespace drydock::rig_config;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr const char* rig_text = R"(
[rig]
name = "boat"
[[device]]
name = "motion"
kind = "imu"
protocol = "xsens"
link = "can:auto"
[[device]]
name = "paddle"
kind = "emlog"
protocol = "nmea0183"
link = "pty:log"
[[device]]
name = "second"
kind = "emlog"
protocol = "nmea0183"
link = "pty:second"
[[estimator]]
name = "level"
kind = "leveling"
filter = "augmented"
imu = "motion"
log = "second"
[[expect]]
estimator = "level"
roll_rms_deg_max = 1
)";

Rig loaded(const std::string& choice) {
  return load_rig_text(with_estimator(rig_text, choice), "boat.toml").value();
}

std::string refusal(const std::string& choice) {
  try {
    with_estimator(rig_text, choice);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(WithEstimator, TakesTheRigsOwnByItsNameOrItsKind) {
  for (const char* choice : {"level", "leveling"}) {
    const auto rig = loaded(choice);
    EXPECT_THAT(rig.devices, SizeIs(3));
    EXPECT_THAT(rig.expects, IsEmpty());
    ASSERT_THAT(rig.estimators, SizeIs(1));
    const auto& kind = std::get<LevelingConfig>(rig.estimators[0].kind);
    EXPECT_EQ(kind.filter, LevelingFilter::augmented);
    EXPECT_EQ(kind.log, "second");
  }
}

TEST(WithEstimator, GivesANewOneOnlyDevicesThatAreNotLeftOut) {
  const std::vector<std::string> left_out{"paddle"};
  const auto rig = load_rig_text(with_estimator(rig_text,
                                                "dead-reckoning:reckoning.latitude_deg=1:"
                                                "reckoning.longitude_deg=2",
                                                left_out),
                                 "boat.toml")
                       .value();
  EXPECT_EQ(std::get<ReckoningConfig>(rig.estimators.at(0).kind).log, "second");
  const std::vector<std::string> both{"paddle", "second"};
  EXPECT_THAT(with_estimator(rig_text, "dead-reckoning", both), Not(HasSubstr("log = ")));
}

TEST(WithEstimator, ChangesItsKeysAndKeepsTheOthers) {
  const auto rig = loaded(
      "level:filter=robust:log=paddle:start=given:initial_roll_deg=2.5:"
      "initial_pitch_deg=0");
  const auto& kind = std::get<LevelingConfig>(rig.estimators.at(0).kind);
  EXPECT_EQ(kind.filter, LevelingFilter::robust);
  EXPECT_EQ(kind.log, "paddle");
  EXPECT_EQ(rig.estimators[0].imu, "motion");
}

TEST(WithEstimator, GivesAKindThatTheRigLacksTheFirstDeviceOfEachKind) {
  const auto rig = loaded("mixing");
  ASSERT_THAT(rig.estimators, SizeIs(1));
  EXPECT_EQ(rig.estimators[0].imu, "motion");
  EXPECT_EQ(std::get<MixingConfig>(rig.estimators[0].kind).log, "paddle");
}

TEST(WithEstimator, SetsKeysInsideATable) {
  const auto rig = loaded("dead-reckoning:reckoning.scale_sigma=0.01:heading=");
  EXPECT_DOUBLE_EQ(std::get<ReckoningConfig>(rig.estimators.at(0).kind).scale_sigma, 0.01);
}

TEST(WithEstimator, RefusesWhatIsNeitherANameNorAKind) {
  EXPECT_THAT(refusal("kalman"), HasSubstr("kalman: the rig has no estimator of this name"));
  EXPECT_THAT(refusal("kalman"), HasSubstr("dead-reckoning"));
  EXPECT_THAT(refusal("level:robust"), HasSubstr("an option is KEY=VALUE"));
  EXPECT_THAT(refusal("level:=1"), HasSubstr("an option is KEY=VALUE"));
}

TEST(SplitValues, LeavesSeparatorsInsideBracketsAndQuotes) {
  EXPECT_THAT(split_values("a,b:k=[1, 2],c:t=\"x,y\"", ','),
              ElementsAre("a", "b:k=[1, 2]", "c:t=\"x,y\""));
  EXPECT_THAT(split_values("", ','), ElementsAre(""));
}

}  // namespace with_estimator_test
