// Files as other programs write them, by the public descriptions of their formats.
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "hil/score/text_format.hpp"
#include "tests/hil/score/partial.hpp"

namespace drydock::score::other_files_test {

using namespace partial_test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Estimates csv(const std::string& text) {
  std::istringstream in(text);
  const auto read = read_csv(in, "a.csv", origin);
  EXPECT_TRUE(read) << read.error().line;
  return read ? *read : Estimates{};
}

std::int64_t ns_of(const State& state) { return state.at.time_since_epoch().count(); }

// The head and the first line of EuRoC's MAV data set, state_groundtruth_estimate0/data.csv.
TEST(AnotherFile, OfEurocHasNanosecondsAndAxesEastNorthUp) {
  const auto read =
      csv("#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], "
          "q_RS_z [], v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1], b_w_RS_S_x [rad "
          "s^-1]\r\n"
          "1403636580838555648,4.688319,-1.786938,0.783338,1,0,0,0,-0.027876,0.033207,0.800006,"
          "-0.003172\r\n");
  ASSERT_EQ(read.track.size(), 1U);
  const State& state = read.track[0];
  EXPECT_EQ(ns_of(state), 1403636580838555648);
  EXPECT_EQ(state.position_ned, Vector3d(-1.786938, 4.688319, -0.783338));
  EXPECT_NEAR(state.angles.z(), 90 * degree, 1e-12) << "no turn: the bow is east";
  EXPECT_EQ(state.velocity, Vector3d(0.033207, -0.027876, -0.800006));
  EXPECT_FALSE(state.velocity_in_body);
  EXPECT_THAT(read.notes, ElementsAre("1 column is not read: b_w_RS_S_x [rad s^-1]"));
}

// As `rostopic echo -p` of ROS 1 names an Odometry.
TEST(AnotherFile, OfRostopicEchoHasTheStampOfItsHeader) {
  const auto read = csv(
      "%time,field.header.seq,field.header.stamp,field.header.frame_id,field.child_frame_id,"
      "field.pose.pose.position.x,field.pose.pose.position.y,field.pose.pose.position.z,"
      "field.pose.pose.orientation.x,field.pose.pose.orientation.y,field.pose.pose.orientation.z,"
      "field.pose.pose.orientation.w,field.twist.twist.linear.x,field.twist.twist.linear.y,"
      "field.twist.twist.linear.z,field.twist.twist.angular.x\n"
      "1700000000900000000,1,1700000000500000000,odom,base,3,4,5,0,0,0,1,1.5,0.25,0.125,9\n");
  ASSERT_EQ(read.track.size(), 1U);
  EXPECT_EQ(ns_of(read.track[0]), 1700000000500000000);
  EXPECT_EQ(read.track[0].position_ned, Vector3d(4, 3, -5));
  EXPECT_EQ(read.track[0].velocity, Vector3d(1.5, -0.25, -0.125));
  EXPECT_TRUE(read.track[0].velocity_in_body);
  EXPECT_THAT(read.notes, ElementsAre(HasSubstr("4 columns are not read: field.header.seq")));
}

TEST(AnotherFile, OfARosBagHasItsTimeInTwoColumns) {
  for (const char* head :
       {".header.stamp.secs,.header.stamp.nsecs,.pose.position.x,.pose.position.y,.pose.position.z",
        "header.stamp.sec,header.stamp.nanosec,pose.pose.position.x,pose.pose.position.y,"
        "pose.pose.position.z",
        "/fix/header/stamp/sec,/fix/header/stamp/nanosec,/odom/pose/pose/position/x,"
        "/odom/pose/pose/position/y,/odom/pose/pose/position/z"}) {
    const auto read = csv(std::string(head) + "\n1700000000,5,3,4,5\n");
    ASSERT_EQ(read.track.size(), 1U) << head;
    EXPECT_EQ(ns_of(read.track[0]), 1700000000000000005) << head;
    EXPECT_EQ(read.track[0].position_ned, Vector3d(4, 3, -5)) << head;
    EXPECT_THAT(read.notes, IsEmpty());
  }
}

/// REP-103 and nav_msgs/Odometry: 36 numbers by rows, of x, y, z east, north, up and of turns about
/// them; of the twist forward, left, up.
TEST(AnotherFile, OfRosHasTheCovariancesOfItsMessages) {
  for (const std::string name :
       {"pose.covariance.", "field.pose.covariance", "/odom/pose/covariance["}) {
    std::string head =
        "t_s,x,y,z,pose.orientation.w,pose.orientation.x,pose.orientation.y,"
        "pose.orientation.z,twist.twist.linear.x,twist.twist.linear.y,twist.twist.linear.z";
    std::string row = "1,3,4,5,0.70710678,0,0,0.70710678,1.5,0.25,0.125";  // the bow is north
    for (int i = 0; i < 36; ++i) {
      head += "," + name + std::to_string(i) + (name.back() == '[' ? "]" : "");
      row += i == 0             ? ",4"
             : i == 7           ? ",9"
             : i == 14          ? ",1"
             : i == 1 || i == 6 ? ",2"
             : i == 21          ? ",0.01"
             : i == 28          ? ",0.04"
             : i == 35          ? ",0.09"
                                : ",0";
    }
    for (int i = 0; i < 36; ++i) {
      head += ",twist.covariance." + std::to_string(i);
      row += i == 0 ? ",0.25" : i == 7 || i == 14 ? ",1" : i == 1 || i == 6 ? ",0.125" : ",0";
    }
    const auto read = csv(head + "\n" + row + "\n");
    ASSERT_EQ(read.track.size(), 1U) << name;
    EXPECT_THAT(read.notes, IsEmpty()) << name;
    const State& state = read.track[0];
    ASSERT_TRUE(state.position_m2 && state.angles_rad2 && state.velocity_m2ps2) << name;
    EXPECT_EQ(*state.position_m2, (Eigen::Matrix3d{{9, 2, 0}, {2, 4, 0}, {0, 0, 1}}));
    // The bow is north, so that a turn about north is a roll, one about east a pitch.
    EXPECT_TRUE(state.angles_rad2->isApprox(
        Eigen::Matrix3d(Vector3d(0.04, 0.01, 0.09).asDiagonal()), 1e-6));
    EXPECT_EQ(*state.velocity_m2ps2,
              (Eigen::Matrix3d{{0.25, -0.125, 0}, {-0.125, 1, 0}, {0, 0, 1}}));
  }
}

/// ROS says by a variance of -1 or above 1e6 that a number is none.
TEST(AnotherFile, OfRosMayTellAPlaceWithoutAHeading) {
  const auto read =
      csv("t_s,x,y,z,pose.orientation.w,pose.orientation.x,pose.orientation.y,pose.orientation.z,"
          "pose.covariance.0,pose.covariance.21,pose.covariance.28,pose.covariance.35\n"
          "1,3,4,5,1,0,0,0,4,0.01,0.01,-1\n");
  ASSERT_EQ(read.track.size(), 1U);
  EXPECT_TRUE(std::isnan(read.track[0].angles.z()));
  EXPECT_NEAR(read.track[0].angles.x(), 0, 1e-12);
  EXPECT_FALSE(read.track[0].position_m2) << "eight of its numbers are not there";
  EXPECT_THAT(read.notes, testing::Contains(HasSubstr("the covariance of its position is none")));
}

TEST(AnotherFile, OfRos2TopicEchoNeedsNoNames) {
  std::string zeros;
  for (int i = 0; i < 36; ++i) zeros += ",0.0";
  const auto read = csv("1700000000,500000000,map,3.0,4.0,5.0,0.0,0.0,0.0,1.0" + zeros +
                        "\n1700000001,500000000,map,3.0,4.0,5.0,0.0,0.0,0.0,1.0" + zeros + "\n");
  ASSERT_EQ(read.track.size(), 2U);
  EXPECT_EQ(ns_of(read.track[1]), 1700000001500000000);
  EXPECT_EQ(read.track[0].position_ned, Vector3d(4, 3, -5));
}

TEST(AnotherFile, OfASpreadsheetHasSemicolonsAndDecimalCommas) {
  const auto read = csv(
      "\xEF\xBB\xBFtime(s);lat [deg];lon [deg];alt [ft];heading [rad];\"speed; over ground\"\r\n"
      "1,5;60,0;5,0;-10;1,5;2\r\n");
  ASSERT_EQ(read.track.size(), 1U);
  EXPECT_EQ(ns_of(read.track[0]), 1'500'000'000);
  EXPECT_NEAR(read.track[0].position_ned.x(), 0, 1e-6);
  EXPECT_NEAR(read.track[0].position_ned.z(), -20 + 10 * 0.3048, 1e-9);
  EXPECT_NEAR(read.track[0].angles.z(), 1.5, 1e-12);
  EXPECT_THAT(read.notes, ElementsAre("1 column is not read: speed; over ground"));
}

TEST(AnotherFile, HasNamesBehindAnyCommentsAndTimesOfAnyUnit) {
  for (const char* time :
       {"1700000000.25", "1700000000250", "1700000000250000", "1700000000250000000",
        "2023-11-14 22:13:20.25", "2023-11-14T22:13:20.25+00:00", "2023-11-14T22:13:20.250"}) {
    const auto read = csv("# by a filter\n# timestamp,x,y,z,qx,qy,qz,qw\n" + std::string(time) +
                          ",3,4,5,0,0,0,1\n");
    ASSERT_EQ(read.track.size(), 1U) << time;
    EXPECT_EQ(ns_of(read.track[0]), 1700000000250000000) << time;
    EXPECT_NEAR(read.track[0].angles.z(), 90 * degree, 1e-12);
  }
}

TEST(AnotherFile, WithAnglesWithoutAUnitDoesNotHaveThemReadUnsaid) {
  const auto read = csv("t_s,north_m,roll,x [furlong]\n1,2,0.1,7\n");
  EXPECT_TRUE(std::isnan(read.track.at(0).angles.x()));
  EXPECT_THAT(read.notes, ElementsAre("2 columns are not read: roll, x [furlong]"));
}

TEST(AnotherFile, OfTumMayHaveCommasOrTabs) {
  for (const char* text :
       {"1.5,3,4,5,0,0,0,1\r\n", "1.5\t3\t4\t5\t0\t0\t0\t1\n", "1.5;3;4;5;0;0;0;1"}) {
    std::istringstream in(text);
    const auto read = read_tum(in, "a.tum");
    ASSERT_TRUE(read) << read.error().line;
    EXPECT_EQ(read->track.at(0).position_ned, Vector3d(4, 3, -5));
  }
}

// KITTI's odometry: the camera looks along z, x is right, y is down.
TEST(AnotherFile, OfKittiHasItsTimesInASecondOne) {
  const std::string poses = "1 0 0 0 0 1 0 0 0 0 1 0\n0 0 1 2 0 1 0 -1 -1 0 0 7\n";
  std::istringstream none(poses), tum(poses), in(poses), more(poses + poses);
  EXPECT_THAT(read_kitti(none, "00.txt", "").error().line,
              HasSubstr("no times; give --times FILE"));
  EXPECT_THAT(read_tum(tum, "00.txt").error().line, HasSubstr("give --format kitti --times FILE"));
  const std::string times = testing::TempDir() + "times" + std::to_string(::getpid()) + ".txt";
  std::ofstream(times) << "0.000000e+00\n1.037875e-01\n";
  const auto read = read_kitti(in, "00.txt", times);
  ASSERT_TRUE(read) << read.error().line;
  ASSERT_EQ(read->track.size(), 2U);
  EXPECT_EQ(ns_of(read->track[1]), 103'787'500);
  EXPECT_EQ(read->track[1].position_ned, Vector3d(7, 2, -1)) << "ahead, right, up";
  EXPECT_NEAR(read->track[1].angles.z(), 90 * degree, 1e-9) << "it looks to the right";
  EXPECT_THAT(read_kitti(more, "00.txt", times).error().line, HasSubstr("has 4 poses, and"));
}

TEST(AnotherFile, OfGpxIsATrackWithTimes) {
  std::istringstream in(
      "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\"><wpt lat=\"1\" lon=\"2\"/><trk><trkseg>\n"
      "<trkpt lat=\"60.0\" lon=\"5.0\">\n <ele>-22.0</ele>\n <time>1970-01-01T00:00:01Z</time>"
      "</trkpt>\n<trkpt lon='5.0' lat='60.0'/>\n"
      "<trkpt lat=\"60.0\" lon=\"5.0\"><time>1970-01-01T00:00:02.5Z</time></trkpt>"
      "</trkseg></trk></gpx>\n");
  const auto read = read_gpx(in, "a.gpx", origin);
  ASSERT_TRUE(read) << read.error().line;
  ASSERT_EQ(read->track.size(), 2U);
  EXPECT_NEAR(read->track[0].position_ned.z(), 2, 1e-6);
  EXPECT_EQ(ns_of(read->track[1]), 2'500'000'000);
  EXPECT_TRUE(std::isnan(read->track[1].position_ned.z()));
  EXPECT_THAT(read->notes, ElementsAre("a point without a time is left out: 1 point, the first is "
                                       "point 2"));
}

TEST(AnotherFile, OfTextIsWhatItsFirstLineIs) {
  const auto format = [](const char* text) {
    std::istringstream in(text);
    const auto name = format_of_text(in);
    std::string first;
    EXPECT_TRUE(std::getline(in, first) && std::string_view(text).starts_with(first));
    return name;
  };
  EXPECT_EQ(format("\xEF\xBB\xBF# t x y z qx qy qz qw\n1,3,4,5,0,0,0,1\n"), "tum");
  EXPECT_EQ(format("1 0 0 0 0 1 0 0 0 0 1 0\n"), "kitti");
  EXPECT_EQ(format("<?xml version=\"1.0\"?>\n<gpx/>\n"), "gpx");
  EXPECT_EQ(format("t_s north_m\n1 2\n"), "csv");
}

}  // namespace drydock::score::other_files_test
