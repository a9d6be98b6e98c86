#include <gtest/gtest.h>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/motion/missions.hpp"

/// The 5.5 h mission of the velocity-filter paper, Table 1.
namespace drydock::motion {
namespace velocity_paper_test {

const std::string folder = DRYDOCK_SOURCE_DIR "/rig_config/missions/";

struct End {
  double hour, depth_m;
};
// The paper's times and depths; 0.33 h is 288 s after 0.25 h.
constexpr End ends[] = {{0.25, 0}, {0.33, 300}, {0.75, 300}, {1, 150}, {2, 150},
                        {3, 150},  {5, 150},    {5.25, 0},   {5.5, 0}};

const rig_config::MissionConfig& mission() {
  static const auto loaded = rig_config::load_mission(folder + "velocity-paper.toml").value();
  return loaded;
}

/// Sailed only as far as the tests ask, and once for all of them.
const Trajectory& trajectory() {
  static const auto sailed = make_trajectory(mission(), start);
  return *sailed;
}

TEST(VelocityPaper, EachLegEndsAtThePapersTimeDepthAndHeading) {
  ASSERT_EQ(mission().legs.size(), std::size(ends));
  EXPECT_EQ(trajectory().end(), at_s(5.5 * 3600));
  double t = 0;
  for (std::size_t i = 0; i < std::size(ends); ++i) {
    t += mission().legs[i].duration_s;
    EXPECT_NEAR(t, ends[i].hour * 3600, 1e-9);
    const Truth at_end = trajectory().at(at_s(t));
    EXPECT_NEAR(-at_end.height_m, ends[i].depth_m, 1) << ends[i].hour;
    EXPECT_NEAR(at_end.yaw_rad, 45 * degree, 1.5 * degree) << ends[i].hour;
    if (i == 1) continue;  // the spiral after it turns at once
    const Truth settled = trajectory().at(at_s(t + (i == 5 || i == 7 ? 60 : 0)));
    EXPECT_NEAR(-settled.height_m, ends[i].depth_m, i == 3 ? 0.5 : 0.1) << ends[i].hour;
    EXPECT_NEAR(settled.yaw_rad, 45 * degree, 0.2 * degree) << ends[i].hour;
  }
}

TEST(VelocityPaper, GoesAtThreeMetresASecondThroughSpiralAndIntoTheZigzag) {
  double way_m = 0, steepest = 0;
  Truth before = trajectory().at(start);
  constexpr int end_s = 7800;  // end of the zigzag's second leg
  for (int s = 1; s <= end_s; ++s) {
    const Truth now = trajectory().at(at_s(s));
    way_m += frame::ned_offset({before.latitude_rad, before.longitude_rad, before.height_m},
                               {now.latitude_rad, now.longitude_rad, now.height_m})
                 .norm();
    steepest = std::max(steepest, -now.pitch_rad);
    before = now;
  }
  EXPECT_NEAR(way_m, 3 * end_s, 24);
  EXPECT_NEAR(steepest, std::asin(300.0 / 258 / 3), 4 * degree);
  const double early = trajectory().at(at_s(1188 + 73)).rate_body.z();
  const double late = trajectory().at(at_s(2700 - 73)).rate_body.z();
  EXPECT_NEAR(early, 1.5 * degree, 0.05 * degree);
  EXPECT_NEAR(late, 0.5 * degree, 0.05 * degree);
  EXPECT_NEAR(trajectory().at(at_s(7200 + 290)).yaw_rad, 90 * degree, 0.1 * degree);
  EXPECT_NEAR(trajectory().at(at_s(7200 + 590)).yaw_rad, 0, 0.1 * degree);
}

TEST(LevelingStraight, KeepsItsHeadingForThirtySeconds) {
  const auto mission = rig_config::load_mission(folder + "leveling-straight.toml").value();
  const auto trajectory = make_trajectory(mission, start);
  EXPECT_EQ(trajectory->end(), at_s(30));
  EXPECT_EQ(trajectory->at(at_s(30)).yaw_rad, 0);
  EXPECT_NEAR(trajectory->at(at_s(30)).velocity_body.x(), 10, 1e-12);
}

}  // namespace velocity_paper_test
}  // namespace drydock::motion
