// A vehicle that sails between waypoints over its wires, in virtual time.
#include <gtest/gtest.h>

#include <cmath>

#include "hil/bench/run.hpp"
#include "hil/summary/summary.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/load.hpp"

namespace drydock::bench {
namespace waypoint_run_test {

rig_config::Rig waypoint_rig() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/waypoints.toml").value();
}

struct Sailed {
  summary::Summary summary;
  std::string said;
};

Sailed sail(const rig_config::Rig& rig, double seconds) {
  testing::internal::CaptureStdout();
  RunOptions options;
  options.duration_s = seconds;
  auto summary = run_lockstep(rig, options);
  return {std::move(summary), testing::internal::GetCapturedStdout()};
}

// Lines of 150, 112 and 150 m at 1.8, 1.8 and 1.6 m/s are 239 s long. The current of 0.22 m/s is
// against the second and the third, and each turn adds a few metres.
TEST(WaypointRun, PassesAllWaypointsInTheirCirclesAndSaysTheEnd) {
  const auto [summary, said] = sail(waypoint_rig(), 290);
  ASSERT_TRUE(summary.loop);
  const auto& waypoints = summary.loop->waypoints;
  ASSERT_EQ(waypoints.size(), 4);
  EXPECT_FALSE(waypoints[0].passed_s) << "the first line begins there";
  double before_s = 0;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    ASSERT_TRUE(waypoints[i].passed_s) << i;
    EXPECT_TRUE(waypoints[i].reached) << i;
    EXPECT_GT(*waypoints[i].passed_s, before_s);
    EXPECT_LT(std::abs(waypoints[i].cross_track_end_m), 3) << i;
    before_s = *waypoints[i].passed_s;
  }
  EXPECT_GE(waypoints[1].cross_track_max_m, 8) << "it begins 8 m beside the first line";
  EXPECT_LT(waypoints[1].cross_track_max_m, 10);
  EXPECT_NEAR(before_s, (150 + 112) / 1.8 + 150 / 1.6, 35);
  EXPECT_NE(said.find("waypoint 2 of 4 is reached"), std::string::npos) << said;
  EXPECT_NE(said.find("waypoint 4 of 4 is reached"), std::string::npos) << said;
  EXPECT_NE(said.find("it was the last, the vehicle goes straight on"), std::string::npos);
  EXPECT_LT(summary.loop->depth_off_m, 0.2);
}

// Turns with the rudder hard over, at up to 6 deg/s, in a current of 0.22 m/s that each turn brings
// to another side.
TEST(WaypointRun, FindsNothingWhileAllSensorsAreSound) {
  for (const std::uint64_t seed : {1U, 2U}) {
    auto rig = waypoint_rig();
    rig.seed = seed;
    for (const auto& finding : sail(rig, 400).summary.findings)
      ADD_FAILURE() << finding.device << ' ' << finding.cause << " at " << finding.found_s;
  }
}

// Without the DVL the autopilot knows nothing of the current of 0.22 m/s: after 80 s it is 18 m
// off.
TEST(WaypointRun, WithoutTheDvlTheCurrentTakesTheVehicleOffItsWay) {
  auto rig = waypoint_rig();
  rig_config::FaultConfig off;
  off.device = "dvl";
  off.kind = rig_config::FaultKind::off;
  rig.faults = {off};
  EXPECT_NEAR(sail(rig, 80).summary.loop->place_off_m, 80 * std::hypot(0.1, 0.2), 6);
  EXPECT_LT(sail(waypoint_rig(), 80).summary.loop->place_off_m, 2);
}

TEST(WaypointRun, TheSameSeedGivesTheSameWayToTheLastBit) {
  const auto first = sail(waypoint_rig(), 30).summary, second = sail(waypoint_rig(), 30).summary;
  EXPECT_EQ(first.loop->trace.heading_deg.is, second.loop->trace.heading_deg.is);
  EXPECT_EQ(first.loop->place_off_m, second.loop->place_off_m);
}

TEST(WaypointRun, TheReportsMapHasTheWaypointsBesideTheTrack) {
  const auto summary = sail(waypoint_rig(), 5).summary;
  EXPECT_NE(to_html(summary).find("\"waypoints\""), std::string::npos);
  EXPECT_NE(to_json(summary).find("\"cross_track_max_m\""), std::string::npos);
}

}  // namespace waypoint_run_test
}  // namespace drydock::bench
