// Odometries of other programs.
#include <gmock/gmock.h>

#include <Eigen/Core>
#include <limits>

#include "hil/score/read_estimates.hpp"
#include "tests/hil/score/message_file.hpp"

namespace drydock::score {
namespace odometry_test {

using Eigen::Matrix3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Without a twist, as far as the reader cares.
std::string definition() {
  return message_file::with_types(
      "# This represents an estimate of a position and velocity in free space.\n\n"
      "# Includes the frame id of the pose parent.\nstd_msgs/Header header\n\n"
      "string child_frame_id\n\ngeometry_msgs/PoseWithCovariance pose\n",
      {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose", "geometry_msgs/Point",
       "geometry_msgs/Quaternion", "std_msgs/Header", "builtin_interfaces/Time"});
}

/// 7 s and 5 ns; 1 m east, 2 north, 3 up; the bow east. Of the attitude 1 mrad2 each.
std::vector<std::uint8_t> odometry(const Matrix3d& enu) {
  message_file::Cdr cdr;
  cdr.header(7'000'000'005, "map").put(std::string("base_link"));
  cdr.put(std::vector<double>{1, 2, 3, 0, 0, 0, 1});
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column)
      cdr.put(row < 3 && column < 3 ? enu(row, column) : row == column ? 1e-6 : 0.);
  return cdr.bytes;
}

class Odometry : public message_file::WithFile {
 protected:
  Estimates read(const std::vector<std::vector<std::uint8_t>>& messages,
                 const std::string& text = definition()) {
    write(messages, text, {"/odom"});
    auto estimates = read_mcap(path_, "", {});
    EXPECT_TRUE(estimates) << estimates.error().line;
    return *estimates;
  }
  void write(const std::vector<std::vector<std::uint8_t>>& messages, const std::string& text,
             const std::vector<std::string>& names) {
    std::vector<message_file::Topic> topics;
    for (const auto& name : names)
      topics.push_back({name, "nav_msgs/msg/Odometry", text, messages});
    message_file::write(path_, topics);
  }
  std::vector<std::string> notes_of(const Matrix3d& covariance) {
    const auto read_back = read({odometry(covariance)});
    EXPECT_EQ(read_back.track.size(), 1U);
    EXPECT_FALSE(read_back.track.front().position_m2);
    return read_back.notes;
  }
};

TEST_F(Odometry, OfRosbag2IsReadWithItsBareNames) {
  const Matrix3d covariance{{4, 1, 0}, {1, 9, 2}, {0, 2, 16}};
  const auto estimates = read({odometry(covariance)});
  EXPECT_THAT(estimates.notes, IsEmpty());
  ASSERT_EQ(estimates.track.size(), 1U);
  const auto& state = estimates.track.front();
  EXPECT_EQ(state.at.time_since_epoch().count(), 7'000'000'005);
  EXPECT_EQ(state.position_ned, Eigen::Vector3d(2, 1, -3));
  ASSERT_TRUE(state.position_m2);
  EXPECT_EQ(*state.position_m2, (Matrix3d{{9, 1, -2}, {1, 4, 0}, {-2, 0, 16}}));
  ASSERT_TRUE(state.angles_rad2) << "level: roll, pitch and heading are turns about the axes";
  EXPECT_TRUE(state.angles_rad2->isApprox(1e-6 * Matrix3d::Identity(), 1e-12));
}

TEST_F(Odometry, OfTheTruthIsNoEstimateUnlessItIsAskedFor) {
  const std::vector<std::vector<std::uint8_t>> pose{odometry(Matrix3d::Identity())};
  write(pose, definition(), {"/estimate/truth/odometry"});
  EXPECT_EQ(read_mcap(path_, "", {}).error().line,
            path_ +
                ": no estimates in it, only /estimate/truth/odometry; give --topic to score one of "
                "them");
  EXPECT_TRUE(read_mcap(path_, "/estimate/truth/odometry", {}));
  write(pose, definition(), {"/estimate/truth/odometry", "/odom"});
  EXPECT_EQ(read_mcap(path_, "", {})->track.size(), 1U);
  write(pose, definition(), {"/a", "/b"});
  EXPECT_THAT(read_mcap(path_, "", {}).error().line,
              HasSubstr("several topics of nav_msgs/Odometry; give --topic, one of: /a, /b"));
}

TEST_F(Odometry, WhatIsNotReadIsSaidWithItsReason) {
  auto big_endian = odometry(Matrix3d::Identity()), cut = big_endian;
  big_endian[1] = 0;
  cut.resize(100);
  EXPECT_THAT(read({big_endian, big_endian, cut}).notes,
              ElementsAre("its CDR begins with 00 00, and only plain CDR, little endian (00 01) is "
                          "read: 2 messages, the first is message 1",
                          "it ends before its definition does: 1 message, the first is message 3"));
  EXPECT_THAT(read({cut}, "Pose pose\n").notes,
              ElementsAre("its definition does not have nav_msgs/Pose: 1 message, the first is "
                          "message 1"));
  EXPECT_THAT(read({{0, 1, 0, 0, 7}}, "uint8 a\n").notes,
              ElementsAre("it has no header.stamp.sec: 1 message, the first is message 1"));
}

TEST_F(Odometry, AMatrixThatIsNoCovarianceIsLeftOutAndSaid) {
  const std::string of = "the covariance of its position ";
  const std::string end = ": 1 message, the first is message 1";
  EXPECT_THAT(notes_of(Matrix3d{{1, 5, 0}, {5, 1, 0}, {0, 0, 1}}),
              ElementsAre(of + "is none: it has a correlation beyond 1" + end));
  EXPECT_THAT(notes_of(Matrix3d{{1, .9, 0}, {-.9, 1, 0}, {0, 0, 1}}),
              ElementsAre(of + "is none: it is not symmetric" + end));
  EXPECT_THAT(notes_of(Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN())),
              ElementsAre(of + "is none: it has a number that is not finite" + end));
  const std::string unknown = of + "is not known (a variance is not above 0 and below 1e6)" + end;
  EXPECT_THAT(notes_of(Matrix3d::Zero()), ElementsAre(unknown));
  EXPECT_THAT(notes_of(-Matrix3d::Identity()), ElementsAre(unknown));
  EXPECT_THAT(notes_of(1e6 * Matrix3d::Identity()), ElementsAre(unknown));
}

/// As of a filter that knows no depth: its variance of it is 1e6.
TEST_F(Odometry, AVarianceThatIsNotKnownLeavesTheOthers) {
  const Matrix3d covariance{{4, 1, 0}, {1, 9, 0}, {0, 0, 1e6}};
  const auto estimates = read({odometry(covariance)});
  ASSERT_TRUE(estimates.track.front().position_m2);
  const Matrix3d ned = *estimates.track.front().position_m2;
  const Eigen::Matrix2d horizontal{{9, 1}, {1, 4}};
  EXPECT_EQ((ned.topLeftCorner<2, 2>()), horizontal);
  EXPECT_TRUE(std::isnan(ned(2, 2)));
}

}  // namespace odometry_test
}  // namespace drydock::score
