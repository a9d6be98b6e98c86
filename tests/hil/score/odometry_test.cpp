// Odometries of other programs, with the definition that rosbag2 writes: the .msg files of ROS 2
// unchanged, where a type of the same package has no package before its name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Core>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "drivers/recordings/mcap/encoder.hpp"
#include "hil/score/read_estimates.hpp"

namespace drydock::score {
namespace odometry_test {

using Eigen::Matrix3d;
using testing::ElementsAre;
using testing::IsEmpty;

const std::string line(80, '=');

std::string definition() {
  std::string text =
      "# This represents an estimate of a position and velocity in free space.\n\n"
      "# Includes the frame id of the pose parent.\nstd_msgs/Header header\n\n"
      "string child_frame_id\n\ngeometry_msgs/PoseWithCovariance pose\n";
  const auto add = [&](const char* type, const char* fields) {
    text += "\n" + line + "\nMSG: " + type + "\n" + fields;
  };
  add("geometry_msgs/PoseWithCovariance", "Pose pose\n\n# x, y, z\nfloat64[36] covariance\n");
  add("geometry_msgs/Pose", "Point position\nQuaternion orientation\n");
  add("geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n");
  add("geometry_msgs/Quaternion", "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n");
  add("std_msgs/Header", "builtin_interfaces/Time stamp\n\nstring frame_id\n");
  add("builtin_interfaces/Time", "int32 sec\n\nuint32 nanosec\n");
  return text;
}

struct Cdr {
  std::vector<std::uint8_t> bytes{0, 1, 0, 0};
  template <class Number>
  void put(Number number) {
    while ((bytes.size() - 4) % sizeof number != 0) bytes.push_back(0);
    bytes.resize(bytes.size() + sizeof number);
    std::memcpy(&bytes[bytes.size() - sizeof number], &number, sizeof number);
  }
  void put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes.insert(bytes.end(), text.c_str(), text.c_str() + text.size() + 1);
  }
};

/// 7 s and 5 ns; 1 m east, 2 north, 3 up; the bow east.
std::vector<std::uint8_t> odometry(const Matrix3d& enu) {
  Cdr cdr;
  cdr.put(std::int32_t{7});
  cdr.put(std::uint32_t{5});
  cdr.put(std::string("map"));
  cdr.put(std::string("base_link"));
  for (const double value : {1., 2., 3., 0., 0., 0., 1.}) cdr.put(value);
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column)
      cdr.put(row < 3 && column < 3 ? enu(row, column) : 0.);
  return cdr.bytes;
}

class Odometry : public testing::Test {
 protected:
  ~Odometry() override { std::filesystem::remove(path_); }

  Estimates read(const std::vector<std::vector<std::uint8_t>>& messages,
                 const std::string& text = definition()) {
    write(messages, text, {"/odom"});
    auto estimates = read_odometry(path_, "");
    EXPECT_TRUE(estimates) << estimates.error().line;
    return *estimates;
  }
  void write(const std::vector<std::vector<std::uint8_t>>& messages, const std::string& text,
             const std::vector<std::string>& topics) {
    mcap::Buffer file(mcap::magic.begin(), mcap::magic.end());
    mcap::encode(file, mcap::Header{"ros2", "rosbag2"});
    mcap::encode(file, mcap::Schema{1, "nav_msgs/msg/Odometry", "ros2msg", text});
    for (std::uint16_t channel = 1; channel <= topics.size(); ++channel) {
      mcap::encode(file, mcap::Channel{channel, 1, topics[channel - 1U], "cdr", {}});
      for (const auto& message : messages)
        mcap::encode(file, mcap::Message{channel, 1, 9, 9, message});
    }
    mcap::Encoder(file).record(mcap::Opcode::data_end,
                               [&] { mcap::Encoder(file).number(std::uint32_t{0}); });
    mcap::Encoder(file).record(mcap::Opcode::footer, [&] {
      mcap::Encoder(file)
          .number(std::uint64_t{0})
          .number(std::uint64_t{0})
          .number(std::uint32_t{0});
    });
    file.insert(file.end(), mcap::magic.begin(), mcap::magic.end());
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()),
               static_cast<std::streamsize>(file.size()));
  }
  std::vector<std::string> notes_of(const Matrix3d& covariance) {
    const auto read_back = read({odometry(covariance)});
    EXPECT_EQ(read_back.track.size(), 1U);
    EXPECT_FALSE(read_back.track.front().covariance_m2);
    return read_back.notes;
  }

  std::string path_ = testing::TempDir() + "odometry-" + std::to_string(::getpid()) + ".mcap";
};

TEST_F(Odometry, OfRosbag2IsReadWithItsBareNames) {
  const Matrix3d covariance{{4, 1, 0}, {1, 9, 2}, {0, 2, 16}};
  const auto estimates = read({odometry(covariance)});
  EXPECT_THAT(estimates.notes, IsEmpty());
  ASSERT_EQ(estimates.track.size(), 1U);
  const auto& pose = estimates.track.front();
  EXPECT_EQ(pose.at.time_since_epoch().count(), 7'000'000'005);
  EXPECT_EQ(pose.position_ned, Eigen::Vector3d(2, 1, -3));
  ASSERT_TRUE(pose.covariance_m2);
  EXPECT_EQ(*pose.covariance_m2, (Matrix3d{{9, 1, -2}, {1, 4, 0}, {-2, 0, 16}}));
}

TEST_F(Odometry, OfTheTruthIsNoEstimateUnlessItIsAskedFor) {
  const std::vector<std::vector<std::uint8_t>> pose{odometry(Matrix3d::Identity())};
  write(pose, definition(), {"/estimate/truth/odometry"});
  EXPECT_EQ(read_odometry(path_, "").error().line,
            path_ +
                ": of nav_msgs/Odometry it has only the truth, /estimate/truth/odometry; give "
                "--topic to score that");
  EXPECT_TRUE(read_odometry(path_, "/estimate/truth/odometry"));
  write(pose, definition(), {"/estimate/truth/odometry", "/odom"});
  EXPECT_EQ(read_odometry(path_, "")->track.size(), 1U);
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
  const std::string end = ": 1 message, the first is message 1";
  EXPECT_THAT(notes_of(Matrix3d{{1, 5, 0}, {5, 1, 0}, {0, 0, 1}}),
              ElementsAre("its covariance is none: it has a correlation beyond 1" + end));
  EXPECT_THAT(notes_of(Matrix3d{{1, .9, 0}, {-.9, 1, 0}, {0, 0, 1}}),
              ElementsAre("its covariance is none: it is not symmetric" + end));
  EXPECT_THAT(notes_of(Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN())),
              ElementsAre("its covariance is none: it has a number that is not finite" + end));
  const std::string unknown =
      "its covariance is not known (a variance is not above 0 and below 1e6)" + end;
  EXPECT_THAT(notes_of(Matrix3d::Zero()), ElementsAre(unknown));
  EXPECT_THAT(notes_of(-Matrix3d::Identity()), ElementsAre(unknown));
  EXPECT_THAT(notes_of(1e6 * Matrix3d::Identity()), ElementsAre(unknown));
}

}  // namespace odometry_test
}  // namespace drydock::score
