#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "drivers/bus/convert/convert.hpp"

/// Estimates as messages of ROS 2.
namespace drydock::bus::test {
namespace {

TEST(BusConversion, ANavigationWithoutAHeightHasItsEastAndNorth) {
  constexpr double untold = std::numeric_limits<double>::quiet_NaN();
  Navigation navigation;
  navigation.offset_ned = {100, 20, untold};
  navigation.covariance.diagonal() << 1, 4, untold, 0.01, 0.04, 0.09, 1e-6, 2e-6, 3e-6;
  OdometryMessage odometry{};
  ASSERT_TRUE(fill(odometry, navigation));
  EXPECT_EQ(odometry.pose.pose.position.x, 20);
  EXPECT_EQ(odometry.pose.pose.position.y, 100);
  EXPECT_TRUE(std::isnan(odometry.pose.pose.position.z));
  EXPECT_EQ(odometry.pose.covariance[0], 4);
  EXPECT_EQ(odometry.pose.covariance[7], 1);
  NavSatFixMessage fix{};
  ASSERT_TRUE(fill(fix, navigation));
  EXPECT_EQ(fix.position_covariance[0], 4);
}

/// sensor_msgs/NavSatFix: COVARIANCE_TYPE_UNKNOWN is 0, COVARIANCE_TYPE_KNOWN 3.
TEST(BusConversion, ANavigationWithoutACovarianceIsAFixOfUnknownOne) {
  Navigation navigation;
  navigation.covariance.setConstant(std::nan(""));
  NavSatFixMessage message{};
  ASSERT_TRUE(fill(message, navigation));
  EXPECT_EQ(message.position_covariance_type, 0);
  for (const double value : message.position_covariance) EXPECT_EQ(value, 0);

  navigation.covariance.topLeftCorner<2, 2>() = Eigen::Vector2d{4, 9}.asDiagonal();
  ASSERT_TRUE(fill(message, navigation));
  EXPECT_EQ(message.position_covariance_type, 3);
  EXPECT_EQ(message.position_covariance[0], 9);  // east
  EXPECT_EQ(message.position_covariance[4], 4);
  EXPECT_EQ(message.position_covariance[8], 1e6);  // of a height that nobody tells
}

TEST(BusConversion, ANavigationBecomesOdometryInEnuAndFlu) {
  Navigation navigation;
  navigation.offset_ned = {100, 20, 5};
  navigation.velocity_ned = {0, 3, 0.5};  // north, east, down; the heading is east
  navigation.body_to_ned =
      Eigen::Quaterniond{Eigen::AngleAxisd{std::numbers::pi / 2, Eigen::Vector3d::UnitZ()}};
  navigation.covariance.diagonal() << 1, 4, 9, 0.01, 0.04, 0.09, 1e-6, 2e-6, 3e-6;
  navigation.covariance(0, 1) = navigation.covariance(1, 0) = 0.5;
  OdometryMessage message{};
  ASSERT_TRUE(fill(message, navigation));
  EXPECT_DOUBLE_EQ(message.pose.pose.position.x, 20);
  EXPECT_DOUBLE_EQ(message.pose.pose.position.y, 100);
  EXPECT_DOUBLE_EQ(message.pose.pose.position.z, -5);
  EXPECT_NEAR(std::abs(message.pose.pose.orientation.w), 1, 1e-12);  // REP-103: yaw 0 is east
  EXPECT_NEAR(message.twist.twist.linear.x, 3, 1e-12);
  EXPECT_NEAR(message.twist.twist.linear.y, 0, 1e-12);
  EXPECT_NEAR(message.twist.twist.linear.z, -0.5, 1e-12);
  EXPECT_DOUBLE_EQ(message.pose.covariance[0], 4);
  EXPECT_DOUBLE_EQ(message.pose.covariance[1], 0.5);
  EXPECT_DOUBLE_EQ(message.pose.covariance[7], 1);
  EXPECT_DOUBLE_EQ(message.pose.covariance[21], 2e-6);
  EXPECT_NEAR(message.twist.covariance[0], 0.04, 1e-12);
  EXPECT_EQ(message.twist.covariance[35], 1e6) << "no angular velocity";
}

/// robot_localization, src/ekf.cpp: a variance below 0 counts by its amount, one below 1e-9 as
/// 1e-9, a NaN goes into the gain. So a number that gives no weight is the only one that is safe.
TEST(BusConversion, AnOdometryOfWhichNobodyTellsTheCovarianceGetsNoWeightInAFilter) {
  const double untold = std::nan("");
  Navigation navigation;
  navigation.velocity_ned = {1, 0, 0};
  navigation.covariance.setConstant(untold);
  OdometryMessage message{};
  ASSERT_TRUE(fill(message, navigation));
  for (int i = 0; i < 36; ++i) {
    const double expected = i % 7 == 0 ? 1e6 : 0;
    EXPECT_EQ(message.pose.covariance[i], expected) << i;
    EXPECT_EQ(message.twist.covariance[i], expected) << i;
  }
}

TEST(BusConversion, AnOdometryKeepsTheCovariancesThatAreTold) {
  Navigation navigation;
  navigation.covariance.setConstant(std::nan(""));
  navigation.covariance.topLeftCorner<2, 2>() << 1, 0.5, 0.5, 4;  // north and east, no height
  OdometryMessage message{};
  ASSERT_TRUE(fill(message, navigation));
  EXPECT_EQ(message.pose.covariance[0], 4);
  EXPECT_EQ(message.pose.covariance[1], 0.5);
  EXPECT_EQ(message.pose.covariance[7], 1);
  EXPECT_EQ(message.pose.covariance[14], 1e6);
  EXPECT_EQ(message.pose.covariance[2], 0);
  EXPECT_EQ(message.pose.covariance[21], 1e6);
}

}  // namespace
}  // namespace drydock::bus::test
