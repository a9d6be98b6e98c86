#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "estimators/frame/attitude.hpp"
#include "estimators/navigation/aided_navigation.hpp"

// A compass as aiding sensor: eq. (N9) of docs/estimators/navigation.md.
namespace drydock::navigation::heading_aiding_test {
namespace {

using Eigen::Vector3d;

NavigationState state_of(const frame::Euler& attitude) {
  return {{0.7, 0.3, 20}, Vector3d::Zero(), frame::body_to_ned(attitude)};
}

NavigationOptions with_heading_sigma(double sigma) {
  NavigationOptions o;
  o.alignment_rad = {1e-6, 1e-6, sigma};
  o.height_loop_tau_s = 0;
  return o;
}

// The error phi is defined by C_IN = (I - phi x) C, so phi turns the attitude by -phi.
TEST(HeadingAiding, TheRowIsTheDerivativeOfTheYawAngleByPhi) {
  for (const frame::Euler& attitude :
       {frame::Euler{0, 0, 0}, frame::Euler{0.4, -0.7, 2.5}, frame::Euler{-1.2, 0.9, -3.1}}) {
    const Eigen::Quaterniond q = frame::body_to_ned(attitude);
    const HeadingRow row = heading_row(q);
    EXPECT_NEAR(row.heading_rad, attitude.yaw, 1e-14);
    EXPECT_NEAR(row.level, std::cos(attitude.pitch), 1e-14);
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double h = 1e-5;
      const auto yaw_at = [&](double angle) {
        return frame::euler(quaternion_of(-angle * Vector3d::Unit(axis)) * q).yaw;
      };
      const double slope = frame::wrap_pi(yaw_at(h) - yaw_at(-h)) / (2 * h);
      EXPECT_NEAR(row.by_phi(axis), slope, 1e-8) << axis;
    }
  }
}

// Level: h = (0, 0, -1). Innovation variance 0.03^2 + 0.04^2; gain 0.0009 / 0.0025 = 0.36.
TEST(HeadingAiding, ALevelVehicleTakesTheShareOfTheKalmanGain) {
  AidedNavigation aided(state_of({0, 0, 0.5}), with_heading_sigma(0.03));
  EXPECT_EQ(aided.update_heading(0.6, 0.04), 1);
  ASSERT_EQ(aided.innovations().size(), 1U);
  EXPECT_NEAR(aided.innovations()[0].value, 0.1, 1e-12);
  EXPECT_NEAR(aided.innovations()[0].sigma, 0.05, 1e-12);
  EXPECT_NEAR(aided.innovation_square(), 4, 1e-9);
  EXPECT_NEAR(frame::euler(aided.body_to_ned()).yaw, 0.536, 1e-12);
  EXPECT_NEAR(std::sqrt(aided.covariance()(phi + 2, phi + 2)), 0.024, 1e-12);
}

TEST(HeadingAiding, TheInnovationTakesTheShortWayOverNorth) {
  AidedNavigation aided(state_of({0, 0, -0.01}), with_heading_sigma(0.03));
  aided.update_heading(2 * std::numbers::pi - 0.03, 0.04);
  EXPECT_NEAR(aided.innovations().at(0).value, -0.02, 1e-12);
}

TEST(HeadingAiding, AHeadingOutsideTheGateIsCountedAndChangesNothing) {
  NavigationOptions options = with_heading_sigma(0.03);
  options.gate_sigma = 3;
  AidedNavigation aided(state_of({0, 0, 0}), options);
  EXPECT_EQ(aided.update_heading(0.16, 0.04), 0);  // 3.2 sigma
  EXPECT_EQ(aided.rejected(), 1U);
  EXPECT_EQ(frame::euler(aided.body_to_ned()).yaw, 0);
  EXPECT_EQ(aided.update_heading(0.14, 0.04), 1);  // 2.8 sigma
}

TEST(HeadingAiding, ABowThatPointsUpHasNoHeading) {
  AidedNavigation aided(state_of({0, 1.5, 0}), with_heading_sigma(0.03));
  EXPECT_EQ(aided.update_heading(0.1, 0.04), 0);
  EXPECT_TRUE(aided.innovations().empty());
}

}  // namespace
}  // namespace drydock::navigation::heading_aiding_test
