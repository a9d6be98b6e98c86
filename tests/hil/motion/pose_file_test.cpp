#include "hil/motion/splined/pose_file.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"

namespace drydock::motion {
namespace {

using testing::HasSubstr;

constexpr frame::Position origin{36 * units::degree, 129 * units::degree, 0};

std::string refusal(const std::string& text) {
  try {
    parse_poses(text, "way.csv", origin);
  } catch (const BadPoses& error) {
    return error.what();
  }
  return {};
}

TEST(PoseFile, TakesWhatTheTrackCommandWritesAndCountsFromItsFirstLine) {
  const auto poses = parse_poses(
      "time_s,utc,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n"
      "12.5,2026-11-21T08:00:00.250Z,36.0,129.0,-3.5,1.0,-2.0,90.0\r\n"
      "13.5,2026-11-21T08:00:01.250Z,36.001,129.0,-4.5,0,0,95\n",
      "way.csv", {});
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].t_s, 0);
  EXPECT_EQ(poses[1].t_s, 1);
  EXPECT_DOUBLE_EQ(poses[0].position.latitude_rad, 36 * units::degree);
  EXPECT_EQ(poses[0].position.height_m, -3.5);
  const auto angles = frame::euler(poses[0].body_to_ned);
  EXPECT_NEAR(angles.roll, 1 * units::degree, 1e-12);
  EXPECT_NEAR(angles.pitch, -2 * units::degree, 1e-12);
  EXPECT_NEAR(angles.yaw, 90 * units::degree, 1e-12);
}

// A minute of latitude is a nautical mile, 1852 m, within half a percent.
TEST(PoseFile, TakesMetresFromTheMissionsPlaceAndQuaternions) {
  const auto poses = parse_poses(
      "qx,qy,qz,qw,east_m,north_m,down_m,time_s\n"
      "0,0,0.70710678,0.70710678,0,1852,7,0\n"
      "0,0,-0.70710678,-0.70710678,0,1852,7,1\n",
      "way.csv", origin);
  EXPECT_NEAR(poses[0].position.latitude_rad, (36 + 1 / 60.0) * units::degree, 1.5e-6);
  EXPECT_NEAR(poses[0].position.height_m, -7, 0.3);  // 1852 m on the tangent rise by 0.27 m
  EXPECT_NEAR(frame::euler(poses[0].body_to_ned).yaw, 90 * units::degree, 1e-7);
}

TEST(PoseFile, TakesDepthsForHeights) {
  const auto poses = parse_poses(
      "time_s,latitude_deg,longitude_deg,depth_m,roll_deg,pitch_deg,heading_deg\n"
      "0,1,2,30,0,0,0\n1,1,2,31,0,0,0\n",
      "way.csv", origin);
  EXPECT_EQ(poses[1].position.height_m, -31);
}

TEST(PoseFile, SaysInOneLineWhatIsWrongAndWhatIsAllowed) {
  const std::string head =
      "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n";
  EXPECT_THAT(refusal(""), HasSubstr("way.csv:1: fewer than two lines"));
  EXPECT_THAT(refusal("a,b\n"), HasSubstr("way.csv:1: no column time_s"));
  EXPECT_THAT(refusal("time_s,qw,qx,qy,qz\n"), HasSubstr("no position, allowed: latitude_deg"));
  EXPECT_THAT(refusal("time_s,north_m,east_m,down_m\n"),
              HasSubstr("no attitude, allowed: roll_deg"));
  EXPECT_THAT(refusal(head + "0,1,2,3,0,0,0\n"), HasSubstr("fewer than two lines"));
  EXPECT_THAT(refusal(head + "0,1,2,3,0,0,0\n0,1,2,3,0,0,0\n"),
              HasSubstr("way.csv:3: time_s is not later"));
  EXPECT_THAT(refusal(head + "0,1,2,3,0,0,0\n1,1,2,3,0,0,91\n"),
              HasSubstr("way.csv:3: turns by 91 deg"));
  EXPECT_THAT(refusal(head + "0,1,2,3,0,0,0\n1,1,x,3,0,0,0\n"),
              HasSubstr("way.csv:3: longitude_deg: \"x\" is no number"));
  EXPECT_THAT(refusal(head + "0,1,2,3,0,0,0\n1,1,2\n"), HasSubstr("way.csv:3: 3 columns"));
  EXPECT_THAT(refusal(head + "0,1,2,nan,0,0,0\n"), HasSubstr("is no number"));
  EXPECT_THAT(refusal(head + "0,91,2,3,0,0,0\n"), HasSubstr("is no place"));
  EXPECT_THAT(refusal("time_s,north_m,east_m,down_m,qw,qx,qy,qz\n0,0,0,0,2,0,0,0\n"),
              HasSubstr("the quaternion has the length 2.000"));
}

RC_GTEST_PROP(PoseFile, TakesOrRefusesAnyText, ()) {
  static constexpr std::string_view letters = "time_s,qwxyznorthdgheading01.-e\n\r \t";
  std::string text =
      *rc::gen::element<std::string>("", "time_s,north_m,east_m,down_m,qw,qx,qy,qz\n",
                                     "time_s,latitude_deg,longitude_deg,depth_m,"
                                     "roll_deg,pitch_deg,heading_deg\n0,1,2,3,0,0,0\n");
  const auto length = *rc::gen::inRange(0, 200);
  for (int i = 0; i < length; ++i)
    text +=
        letters[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(letters.size())))];
  try {
    RC_ASSERT(parse_poses(text, "way.csv", origin).size() >= 2u);
  } catch (const BadPoses& error) {
    RC_ASSERT(std::string(error.what()).starts_with("way.csv:"));
  }
}

}  // namespace
}  // namespace drydock::motion
