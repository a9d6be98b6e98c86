#include "rig_config/load.hpp"
#include "tests/rig_config/problems.hpp"

/// Rig files: the kind of estimator that has no inertial unit.
namespace drydock::rig_config::test {
namespace reckoning_test {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string head =
    std::string(imu_table) + "[[estimator]]\nname = \"t\"\nkind = \"dead-reckoning\"\n";

TEST(Reckoning, ItNeedsNoInertialUnitAndRefusesOne) {
  EXPECT_THAT(problems_of(head + "dvl = \"dvl\"\n"), testing::IsEmpty());
  EXPECT_THAT(problems_of(head + "dvl = \"dvl\"\nimu = \"imu\"\n"),
              ElementsAre(HasSubstr("/estimator/0/imu: not allowed here, not for kind = "
                                    "\"dead-reckoning\"")));
}

TEST(Reckoning, ALatitudeNeedsALongitudeAndTheOtherWayRound) {
  const std::string start = head + "dvl = \"dvl\"\n[estimator.reckoning]\n";
  EXPECT_THAT(problems_of(start + "latitude_deg = 41.5\n"),
              ElementsAre(HasSubstr("/estimator/0/reckoning: key 'longitude_deg' is missing")));
  EXPECT_THAT(problems_of(start + "longitude_deg = -70.7\n"),
              ElementsAre(HasSubstr("/estimator/0/reckoning/longitude_deg: not allowed here, only "
                                    "with latitude_deg")));
}

TEST(Reckoning, OtherKindsHaveNoTableReckoning) {
  EXPECT_THAT(problems_of(std::string(imu_table) +
                          "[[estimator]]\nname = \"l\"\nkind = \"leveling\"\nimu = \"imu\"\n"
                          "model = \"stationary\"\n[estimator.reckoning]\ngap_s = 3\n"),
              ElementsAre(HasSubstr("/estimator/0/reckoning: not allowed here, only for kind = "
                                    "\"dead-reckoning\"")));
}

TEST(Reckoning, TheShippedRigHasItsKeysInSi) {
  const Rig rig = load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/dead-reckoning.toml").value();
  ASSERT_EQ(rig.estimators.size(), 2u);
  const auto& track = std::get<ReckoningConfig>(rig.estimators[0].kind);
  EXPECT_EQ(track.dvl, "dvl");
  EXPECT_EQ(track.log, "emlog");
  EXPECT_EQ(track.heading, "compass");
  EXPECT_NEAR(track.latitude_rad.value(), 0.628318530717959, 1e-12);
  EXPECT_NEAR(track.heading_sigma_rad, 0.00872664625997165, 1e-12);
  EXPECT_DOUBLE_EQ(track.scale_sigma, 0.002);
  EXPECT_DOUBLE_EQ(track.gap_s, 5);
  const auto& by_log = std::get<ReckoningConfig>(rig.estimators[1].kind);
  EXPECT_FALSE(by_log.latitude_rad);
  EXPECT_EQ(by_log.gnss, "gnss");
  EXPECT_TRUE(rig.estimators[1].imu.empty());
}

}  // namespace reckoning_test
}  // namespace drydock::rig_config::test
