#include <gtest/gtest.h>

#include "estimators/frame/attitude.hpp"
#include "estimators/navigation/aided_navigation.hpp"

// A sensor on a lever also measures attitude or gyro bias, which a sensor at the IMU does not. One
// exact measurement must correct them, so that the end of the lever agrees with the measurement.
namespace drydock::navigation::lever_arm_test {
namespace {

using Eigen::Vector3d;

const Vector3d lever{8, -3, 2};
const NavigationState truth{{0.7, 0.3, 20}, Vector3d::Zero(), frame::body_to_ned({0.1, -0.2, 0.8})};
const Vector3d tilt{2e-4, -3e-4, 5e-4};

NavigationOptions sure_of_the_place() {
  NavigationOptions o;
  o.position_m = o.height_m = o.velocity_mps = 1e-6;
  o.alignment_rad = Vector3d::Constant(1e-2);
  o.height_loop_tau_s = 0;
  return o;
}

NavigationState tilted() {
  NavigationState start = truth;
  start.body_to_ned = quaternion_of(-tilt) * truth.body_to_ned;
  return start;
}

TEST(LeverArm, APositionAtItsEndCorrectsTheAttitude) {
  AidedNavigation aided{tilted(), sure_of_the_place()};
  const frame::Position antenna = frame::at_ned_offset(truth.position, truth.body_to_ned * lever);
  EXPECT_EQ(aided.update_position(antenna, Vector3d::Constant(1e-6), lever), 3);
  const Vector3d seen = frame::ned_offset(truth.position, antenna);
  EXPECT_GT((tilted().body_to_ned * lever - seen).norm(), 1e-3);
  EXPECT_LT((aided.state().body_to_ned * lever - seen).norm(), 2e-5);
}

TEST(LeverArm, AHeightAtItsEndCorrectsTheAttitude) {
  AidedNavigation aided{tilted(), sure_of_the_place()};
  const double up = -(truth.body_to_ned * lever).z();
  EXPECT_EQ(aided.update_height(truth.position.height_m + up, 1e-6, lever), 1);
  EXPECT_GT(std::abs(-(tilted().body_to_ned * lever).z() - up), 1e-3);
  EXPECT_NEAR(-(aided.state().body_to_ned * lever).z(), up, 2e-5);
}

TEST(LeverArm, AVelocityAtItsEndCorrectsTheGyroBias) {
  NavigationOptions options = sure_of_the_place();
  options.alignment_rad = Vector3d::Constant(1e-9);
  options.accel_bias_mps2 = 1e-9;
  options.gyro_bias_radps = 1e-2;
  AidedNavigation aided{truth, options};
  const Vector3d rate{0.3, -0.2, 0.1}, bias{1e-3, 2e-3, -1e-3};
  constexpr double dt = 1e-4;  // too short to move
  aided.add_imu((rate + bias) * dt, Vector3d::Zero(), dt);
  aided.step();
  const NavigationState& now = aided.state();
  const Vector3d seen = now.body_to_ned.conjugate() * now.velocity_ned + rate.cross(lever);
  EXPECT_EQ(aided.update_velocity(seen, Vector3d::Constant(1e-7), lever), 3);
  EXPECT_LT((aided.gyro_bias() - bias).cross(lever).norm(), 1e-4);
}

}  // namespace
}  // namespace drydock::navigation::lever_arm_test
