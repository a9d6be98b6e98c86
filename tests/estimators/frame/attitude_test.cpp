#include "estimators/frame/attitude.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace drydock::frame {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

std::vector<Euler> attitudes() {
  std::vector<Euler> all;
  for (double roll = -170; roll <= 170; roll += 34) {
    for (double pitch = -85; pitch <= 85; pitch += 17) {
      for (double yaw = -175; yaw <= 175; yaw += 35) {
        all.push_back({roll * degree, pitch * degree, yaw * degree});
      }
    }
  }
  return all;
}

/// The definition of 3-2-1: three elementary rotations by Eigen.
Quaterniond yaw_then_pitch_then_roll(const Euler& e) {
  return AngleAxisd{e.yaw, Vector3d::UnitZ()} * AngleAxisd{e.pitch, Vector3d::UnitY()} *
         AngleAxisd{e.roll, Vector3d::UnitX()};
}

TEST(Attitude, MatrixAndQuaternionAreThreeElementaryRotations) {
  for (const Euler& e : attitudes()) {
    const Quaterniond expected = yaw_then_pitch_then_roll(e);
    EXPECT_LT((ned_to_body(e).transpose() - expected.toRotationMatrix()).norm(), 1e-14);
    EXPECT_LT(body_to_ned(e).angularDistance(expected), 1e-7);
    EXPECT_LT((body_to_ned(e).toRotationMatrix() - expected.toRotationMatrix()).norm(), 1e-14);
    EXPECT_GE(body_to_ned(e).w(), 0);
  }
}

TEST(Attitude, Equation1OfTheLevelingPaperCorrectedIsOrthonormalWithDeterminantOne) {
  for (const Euler& e : attitudes()) {
    const Matrix3d c = ned_to_body(e);
    EXPECT_LT((c * c.transpose() - Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(c.determinant(), 1, 1e-14);
  }
}

TEST(Attitude, ANoseUpVehicleSeesGravityBehindAndAStarboardHeelSeesItToStarboard) {
  const Vector3d down{0, 0, 1};
  const Vector3d nose_up = ned_to_body({0, 30 * degree, 0}) * down;
  EXPECT_NEAR(nose_up.x(), -0.5, 1e-15);
  const Vector3d heeled = ned_to_body({30 * degree, 0, 0}) * down;
  EXPECT_NEAR(heeled.y(), 0.5, 1e-15);
}

TEST(Attitude, AVehicleHeadingEastMovesEast) {
  const Vector3d ned = body_to_ned({0, 0, 90 * degree}) * Vector3d{1, 0, 0};
  EXPECT_LT((ned - Vector3d{0, 1, 0}).norm(), 1e-15);
}

TEST(Attitude, EulerAnglesComeBackFromQuaternionAndMatrix) {
  for (const Euler& e : attitudes()) {
    for (const Euler& back : {euler(body_to_ned(e)), euler(ned_to_body(e))}) {
      EXPECT_NEAR(back.roll, e.roll, 1e-13);
      EXPECT_NEAR(back.pitch, e.pitch, 1e-13);
      EXPECT_NEAR(back.yaw, e.yaw, 1e-13);
    }
  }
}

TEST(Attitude, StraightUpAndDownKeepTheRotationAndGiveRollZero) {
  for (const double pitch : {90 * degree, -90 * degree}) {
    const Euler given{20 * degree, pitch, 50 * degree};
    const Euler back = euler(body_to_ned(given));
    EXPECT_EQ(back.roll, 0);
    // The error of the angle from the quaternion's matrix is the square root of the rounding error.
    EXPECT_NEAR(back.pitch, pitch, 1e-7);
    EXPECT_LT((ned_to_body(back) - ned_to_body(given)).norm(), 1e-7);
  }
}

TEST(Attitude, EulerRatesAreTheDerivativeOfTheRotation) {
  const double h = 1e-6;
  const Vector3d rate{0.1, -0.2, 0.3};
  for (const Euler& e : attitudes()) {
    const Quaterniond q = yaw_then_pitch_then_roll(e);
    const Quaterniond turned{q * AngleAxisd{rate.norm() * h, rate.normalized()}};
    const Euler after = euler(turned);
    const Vector3d numeric =
        Vector3d{wrap_pi(after.roll - e.roll), after.pitch - e.pitch, wrap_pi(after.yaw - e.yaw)} /
        h;
    const Vector3d rates = euler_rates(e, rate);
    EXPECT_LT((rates - numeric).norm(), 1e-3 * (1 + rates.norm()));
    EXPECT_LT((body_rate(e, rates) - rate).norm(), 1e-13);
  }
}

TEST(Attitude, SkewIsTheCrossProduct) {
  const Vector3d a{1, -2, 3}, b{0.5, 4, -1};
  EXPECT_LT((skew(a) * b - a.cross(b)).norm(), 1e-15);
}

TEST(Attitude, WrappedAnglesLieAboveMinusPiUpToPi) {
  EXPECT_DOUBLE_EQ(wrap_pi(3 * std::numbers::pi), std::numbers::pi);
  EXPECT_DOUBLE_EQ(wrap_pi(-std::numbers::pi), std::numbers::pi);
  EXPECT_NEAR(wrap_pi(370 * degree), 10 * degree, 1e-15);
  EXPECT_NEAR(wrap_pi(-190 * degree), 170 * degree, 1e-15);
}

}  // namespace
}  // namespace drydock::frame
