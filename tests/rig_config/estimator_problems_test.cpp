#include "tests/rig_config/problems.hpp"

/// Rig files: required and allowed keys of estimators.
namespace drydock::rig_config::test {
namespace estimator_problems_test {

using testing::ElementsAre;

TEST(EstimatorProblems, AnEstimatorsDevicesExistAndAreOfTheRightKind) {
  const std::string more = std::string(imu_table) +
                           "[[estimator]]\nname = \"l\"\nkind = \"leveling\"\nimu = \"imx\"\n"
                           "log = \"dvl\"\n";
  EXPECT_THAT(problems_of(more),
              ElementsAre("r.toml:16:7: /estimator/0/imu: no device is named \"imx\" (did you mean "
                          "'imu'?), allowed: imu",
                          "r.toml:17:7: /estimator/0/log: device \"dvl\" is of kind dvl, this rig "
                          "has no device of kind emlog"));
}

TEST(EstimatorProblems, KeysThatDependOnAChoiceSaySo) {
  const std::string head =
      std::string(imu_table) + "[[estimator]]\nname = \"l\"\nkind = \"leveling\"\nimu = \"imu\"\n";
  EXPECT_THAT(problems_of(head), ElementsAre("r.toml:13:1: /estimator/0: key 'log' is missing"));
  EXPECT_THAT(problems_of(head + "model = \"stationary\"\ninitial_roll_deg = 1\n"),
              ElementsAre("r.toml:18:1: /estimator/0/initial_roll_deg: not allowed here, only with "
                          "start = \"given\""));
  EXPECT_THAT(problems_of(head + "model = \"stationary\"\nstart = \"given\"\n"
                                 "initial_roll_deg = 1\n"),
              ElementsAre("r.toml:13:1: /estimator/0: key 'initial_pitch_deg' is missing"));
}

TEST(EstimatorProblems, KeysOfOneKindOfEstimatorAreNotThoseOfAnother) {
  const auto head = [](const std::string& kind) {
    return std::string(imu_table) + "[[estimator]]\nname = \"l\"\nkind = \"" + kind +
           "\"\nimu = \"imu\"\n";
  };
  EXPECT_THAT(problems_of(head("leveling") + "model = \"stationary\"\ntype = \"type2\"\n"),
              ElementsAre("r.toml:18:1: /estimator/0/type: not allowed here, only for kind = "
                          "\"mixing\""));
  EXPECT_THAT(problems_of(head("mixing") + "filter = \"robust\"\n"),
              testing::UnorderedElementsAre(
                  "r.toml:13:1: /estimator/0: key 'log' is missing",
                  "r.toml:17:1: /estimator/0/filter: not allowed here, only for kind = "
                  "\"leveling\""));
}

TEST(EstimatorProblems, ThePapersFilterStartsFromAGivenAttitudeAlone) {
  const std::string head = std::string(imu_table) +
                           "[[estimator]]\nname = \"l\"\nkind = \"leveling\"\nimu = \"imu\"\n"
                           "model = \"stationary\"\n";
  EXPECT_THAT(problems_of(head + "filter = \"paper\"\n"),
              ElementsAre("r.toml:13:1: /estimator/0: key 'start' is missing"));
  EXPECT_THAT(problems_of(head + "filter = \"paper\"\nstart = \"accelerometer\"\n"),
              ElementsAre("r.toml:19:9: /estimator/0/start: \"accelerometer\" is not allowed, "
                          "allowed: given"));
  EXPECT_THAT(problems_of(head + "filter = \"augmentd\"\n"),
              ElementsAre("r.toml:18:10: /estimator/0/filter: \"augmentd\" is not allowed (did you "
                          "mean 'augmented'?), allowed: robust, augmented, paper"));
}

TEST(EstimatorProblems, ARollEstimatorNeedsAReceiverAndHasNoLog) {
  const std::string head =
      std::string(imu_table) + "[[estimator]]\nname = \"r\"\nkind = \"roll\"\nimu = \"imu\"\n";
  EXPECT_THAT(problems_of(head), ElementsAre("r.toml:13:1: /estimator/0: key 'gnss' is missing"));
  EXPECT_THAT(problems_of(head + "gnss = \"imu\"\n"),
              ElementsAre("r.toml:17:8: /estimator/0/gnss: device \"imu\" is of kind imu, this rig "
                          "has no device of kind gnss"));
}

TEST(EstimatorProblems, AnInertialNavigationNeedsAStartAndItsSensorsGrades) {
  const std::string head = std::string(imu_table) +
                           "[[estimator]]\nname = \"n\"\nkind = \"navigation\"\nimu = \"imu\"\n";
  EXPECT_THAT(problems_of(head),
              ElementsAre("r.toml:13:1: /estimator/0: key 'sensors' is missing",
                          "r.toml:13:1: /estimator/0: key 'initial' is missing"));
}

}  // namespace estimator_problems_test
}  // namespace drydock::rig_config::test
