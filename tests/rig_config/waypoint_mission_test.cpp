#include <gmock/gmock.h>

#include "tests/rig_config/problems.hpp"

namespace drydock::rig_config::test {
namespace waypoint_mission_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string place =
    "[mission]\nlatitude_deg = 36\nlongitude_deg = 129\ndepth_m = 3\nspeed_mps = 1.5\n"
    "[steering]\nfrom = \"wires\"\n";

std::vector<std::string> problems_with(const std::string& more) {
  const auto mission = load_mission_text(place + more, "m.toml");
  return mission ? std::vector<std::string>{} : lines_of(mission.error());
}

TEST(WaypointMission, DepthAndSpeedStayWhereTheyAreNotGiven) {
  const auto mission = load_mission_text(
      place +
          "[guidance]\nlookahead_m = 9\nintegral_gain_mps = 0.2\n"
          "[[waypoint]]\nnorth_m = 0\neast_m = 5\n"
          "[[waypoint]]\nnorth_m = 100\neast_m = 5\ndepth_m = 6\nspeed_mps = 1.2\nradius_m = 7\n"
          "[[waypoint]]\nnorth_m = 100\neast_m = -90\n",
      "m.toml");
  ASSERT_TRUE(mission) << lines_of(mission.error()).front();
  EXPECT_EQ(mission->guidance.lookahead_m, 9);
  EXPECT_EQ(mission->guidance.integral_gain_mps, 0.2);
  ASSERT_EQ(mission->waypoints.size(), 3);
  EXPECT_EQ(mission->waypoints[0].depth_m, 3);
  EXPECT_EQ(mission->waypoints[0].speed_mps, 1.5);
  EXPECT_EQ(mission->waypoints[1].radius_m, 7);
  EXPECT_EQ(mission->waypoints[2].depth_m, 6);
  EXPECT_EQ(mission->waypoints[2].speed_mps, 1.2);
  EXPECT_EQ(mission->waypoints[2].radius_m, 0);
  EXPECT_EQ(mission->waypoints[2].east_m, -90);
}

TEST(WaypointMission, OneWaypointIsNoLine) {
  EXPECT_THAT(problems_with("[[waypoint]]\nnorth_m = 9\neast_m = 5\n"),
              ElementsAre(HasSubstr("m.toml:8:1: /waypoint: ")));
}

TEST(WaypointMission, TwoAtOnePlaceAreNoLine) {
  EXPECT_THAT(problems_with("[[waypoint]]\nnorth_m = 9\neast_m = 5\n"
                            "[[waypoint]]\nnorth_m = 9\neast_m = 5\ndepth_m = 4\n"),
              ElementsAre("m.toml:11:1: /waypoint/1: is at the place of the one before it, "
                          "allowed: another north_m or east_m"));
}

TEST(WaypointMission, NumbersThatAreNoPlaceAreRefused) {
  for (const char* number : {"nan", "inf", "1e9", "-1e9", "\"far\""})
    EXPECT_THAT(problems_with(std::string("[[waypoint]]\nnorth_m = 9\neast_m = 5\n"
                                          "[[waypoint]]\nnorth_m = 9\neast_m = ") +
                              number + "\n"),
                ElementsAre(HasSubstr("m.toml:13:10: /waypoint/1/east_m: ")))
        << number;
}

TEST(WaypointMission, LegsBesideWaypointsAndGuidanceWithoutThemAreRefused) {
  const std::string leg = "[[leg]]\nkind = \"straight\"\nduration_s = 5\n";
  const std::string two =
      "[[waypoint]]\nnorth_m = 0\neast_m = 5\n[[waypoint]]\nnorth_m = 9\neast_m = 5\n";
  EXPECT_THAT(problems_with(leg + two),
              Contains(HasSubstr("/leg: not allowed here, not with [[waypoint]]")));
  EXPECT_THAT(problems_with(leg + "[guidance]\nlookahead_m = 9\n"),
              Contains(HasSubstr("/guidance: not allowed here, only with [[waypoint]]")));
  EXPECT_THAT(problems_with(two + "[guidance]\nlookahead_m = 0\n"),
              Contains(HasSubstr("/guidance/lookahead_m: ")));
}

TEST(WaypointMission, WithoutOrdersOverTheWiresItNeedsAVehicle) {
  const auto mission = load_mission_text(
      "[mission]\nlatitude_deg = 36\nlongitude_deg = 129\nspeed_mps = 1.5\n"
      "[[waypoint]]\nnorth_m = 0\neast_m = 5\n[[waypoint]]\nnorth_m = 9\neast_m = 5\n",
      "m.toml");
  ASSERT_FALSE(mission);
  EXPECT_THAT(lines_of(mission.error()), ElementsAre(HasSubstr("vehicle")));
}

}  // namespace waypoint_mission_test
}  // namespace drydock::rig_config::test
