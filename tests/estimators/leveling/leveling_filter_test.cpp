#include "estimators/leveling/leveling_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "tests/estimators/leveling/s_path.hpp"

namespace drydock::leveling {
namespace {

using Eigen::Vector3d;
using frame::Euler;
using test::degree;
using test::dt;
using test::Reading;
using test::SPath;

LevelingOptions at_36_degrees(double heading = 0) {
  LevelingOptions options;
  options.latitude_rad = test::latitude;
  options.heading_rad = heading;
  return options;
}

/// Runs the stationary model with perfect sensors on a vehicle at rest.
LevelingFilter settle(LevelingOptions options, const Euler& truth, double seconds) {
  SPath rest{0, 0, 30, truth.roll, truth.pitch, truth.yaw};
  options.heading_rad = truth.yaw;
  LevelingFilter filter{options};
  for (double t = 0; t < seconds; t += dt) {
    const Reading reading = rest.at(t);
    if (t == 0) filter.start(reading.specific_force, reading.angular_rate, 0);
    filter.predict(reading.specific_force, reading.angular_rate, dt);
    filter.update_stationary();
  }
  return filter;
}

TEST(LevelingFilter, PerfectSensorsAtRestGiveTheTrueAttitude) {
  for (const Euler& truth : {Euler{0, 0, 0}, Euler{20 * degree, -10 * degree, 75 * degree},
                             Euler{-100 * degree, 60 * degree, -130 * degree}}) {
    const LevelingFilter filter = settle(at_36_degrees(), truth, 30);
    EXPECT_NEAR(filter.roll(), truth.roll, 1e-6);
    EXPECT_NEAR(filter.pitch(), truth.pitch, 1e-6);
    EXPECT_NEAR(filter.heading(), truth.yaw, 1e-6);
  }
}

TEST(LevelingFilter, AWrongFirstAttitudeIsForgottenAtRest) {
  LevelingOptions options = at_36_degrees();
  options.accelerometer_start = false;
  options.initial_roll_rad = 70 * degree;
  options.initial_pitch_rad = -40 * degree;
  const LevelingFilter filter = settle(options, {5 * degree, 3 * degree, 0}, 300);
  EXPECT_NEAR(filter.roll(), 5 * degree, 1e-4);
  EXPECT_NEAR(filter.pitch(), 3 * degree, 1e-4);
}

TEST(LevelingFilter, AccelerometerStartTakesTheTurnOutOfTheSpecificForce) {
  const SPath turning{10, 45 * degree, 30, 4 * degree, -3 * degree, 0};
  const Reading reading = turning.at(0);  // r V / g = 9.6 degrees of apparent heel
  LevelingFilter filter{at_36_degrees()};
  filter.start(reading.specific_force, reading.angular_rate, reading.speed);
  // Only the Coriolis acceleration remains, eq. (15): 2 Omega V / g.
  EXPECT_NEAR(filter.roll(), 4 * degree, 0.01 * degree);
  EXPECT_NEAR(filter.pitch(), -3 * degree, 0.01 * degree);
}

TEST(LevelingFilter, FreeFallStartsFromTheGivenAttitude) {
  LevelingOptions options = at_36_degrees();
  options.initial_roll_rad = 0.1;
  LevelingFilter filter{options};
  filter.start(Vector3d::Zero(), Vector3d::Zero(), 0);
  EXPECT_NEAR(filter.roll(), 0.1, 1e-15);
}

/// Eq. (26) from its original equations: the paper's (4) for the angles, (12) for the velocity.
LevelingFilter::State derivative(const LevelingFilter::State& x, const Vector3d& force,
                                 const Vector3d& rate_nb, const Vector3d& rate_coriolis,
                                 double gravity) {
  const Vector3d v = x.head<3>(), alpha = x.tail<3>();
  LevelingFilter::State dx;
  dx << force - rate_coriolis.cross(v) + gravity * alpha, -rate_nb.cross(alpha);
  return dx;
}

TEST(LevelingFilter, SystemMatrixIsTheDerivativeOfTheEquationsOfMotion) {
  const Vector3d force{0.3, -0.2, -9.7}, rate_nb{0.1, -0.4, 0.2}, rate_coriolis{0.11, -0.41, 0.19};
  LevelingFilter::State x;
  x << 9, -1, 0.5, -0.1, 0.2, 0.97;
  const auto f = system_matrix(rate_nb, rate_coriolis, 9.8);
  for (int i = 0; i < 6; ++i) {
    const LevelingFilter::State h = 1e-3 * LevelingFilter::State::Unit(i);
    const LevelingFilter::State numeric = (derivative(x + h, force, rate_nb, rate_coriolis, 9.8) -
                                           derivative(x - h, force, rate_nb, rate_coriolis, 9.8)) /
                                          2e-3;
    EXPECT_LT((f.col(i) - numeric).norm(), 1e-11);
  }
}

TEST(LevelingFilter, AlphaFollowsTheEulerAnglesOfEquation4) {
  // d(alpha)/dt of eq. (7) against alpha of eq. (5) with angles integrated from the Euler rates
  const Euler e{0.3, -0.5, 1.0};
  const Vector3d rate_nb{0.1, -0.4, 0.2}, rates = frame::euler_rates(e, rate_nb);
  const double h = 1e-6;
  const auto down = [&](double t) -> Vector3d {
    return frame::ned_to_body({e.roll + t * rates.x(), e.pitch + t * rates.y(), e.yaw}).col(2);
  };
  const Vector3d numeric = (down(h) - down(-h)) / (2 * h);
  const auto f = system_matrix(rate_nb, Vector3d::Zero(), 9.8);
  EXPECT_LT((f.bottomRightCorner<3, 3>() * down(0) - numeric).norm(), 1e-9);
}

TEST(LevelingFilter, PredictionAloneKeepsTheNormOfAlphaForAnHour) {
  LevelingFilter filter{at_36_degrees()};
  filter.start({0, 0, -9.8}, Vector3d::Zero(), 0);
  for (int i = 0; i < 360000; ++i) filter.predict({0, 0, -9.8}, {0.1, -0.2, 0.3}, dt);
  // Third order: the error of |e^A| is (w dt)^4 / 24 per step.
  EXPECT_NEAR(filter.state().tail<3>().norm(), 1, 1e-5);
}

TEST(LevelingFilter, PredictionAloneFollowsTheMotion) {
  LevelingOptions options = at_36_degrees();
  options.accelerometer_start = false;
  const SPath path{10, 45 * degree, 30, 6 * degree, 2 * degree, 0};
  options.initial_roll_rad = path.roll;
  options.initial_pitch_rad = path.pitch;
  LevelingFilter filter{options};
  for (int i = 0; i < 3000; ++i) {
    const Reading r = path.at(i * dt);
    if (i == 0) filter.start(r.specific_force, r.angular_rate, r.speed);
    filter.predict(r.specific_force, r.angular_rate, dt);
  }
  EXPECT_NEAR(filter.roll(), path.roll, 1e-6);
  EXPECT_NEAR(filter.pitch(), path.pitch, 1e-6);
  EXPECT_NEAR(filter.heading(), 0, 1e-5);  // sin(2 pi) = 0
  EXPECT_LT((filter.state().head<3>() - Vector3d{10, 0, 0}).norm(), 1e-3);
}

TEST(LevelingFilter, CovarianceStaysSymmetricAndPositive) {
  test::Table1Sensors sensors{7};
  const SPath path;
  LevelingFilter filter{at_36_degrees()};
  for (int i = 0; i < 30000; ++i) {
    const Reading r = sensors(path.at(i * dt));
    if (i == 0) filter.start(r.specific_force, r.angular_rate, r.speed);
    filter.predict(r.specific_force, r.angular_rate, dt);
    filter.update_nonholonomic(dt);
    filter.update_moving(r.speed);
    if (i % 1000 != 0) continue;
    const auto& p = filter.covariance();
    EXPECT_LT((p - p.transpose()).norm(), 1e-15);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<LevelingFilter::Covariance>{p}.eigenvalues()(0), 0);
  }
}

TEST(LevelingFilter, RollPitchCovarianceIsThatOfAlphaThroughTheAngles) {
  const LevelingFilter filter = settle(at_36_degrees(), {0.4, -0.3, 0.2}, 0.5);
  const Vector3d alpha = filter.state().tail<3>();
  const auto angles = [](const Vector3d& a) {  // eq. (28) as printed, with the normalised vector
    return Eigen::Vector2d{std::atan2(a.y(), a.z()), std::asin(-a.normalized().x())};
  };
  Eigen::Matrix<double, 2, 3> jacobian;
  for (int i = 0; i < 3; ++i) {
    const Vector3d h = 1e-6 * Vector3d::Unit(i);
    jacobian.col(i) = (angles(alpha + h) - angles(alpha - h)) / 2e-6;
  }
  const Eigen::Matrix2d expected =
      jacobian * filter.covariance().bottomRightCorner<3, 3>() * jacobian.transpose();
  EXPECT_LT((filter.roll_pitch_covariance() - expected).norm(), 1e-8 * expected.norm());
}

TEST(LevelingFilter, InnovationIsMeasurementLessPredictionWithItsNormalisedSquare) {
  LevelingOptions options = at_36_degrees();
  options.initial_velocity_sigma_mps = 2;
  options.speed_sigma_mps = 1.5;
  LevelingFilter filter{options};
  filter.start({0, 0, -9.8}, Vector3d::Zero(), 3);
  filter.update_moving(8);
  EXPECT_EQ(filter.innovation().size, 2);
  EXPECT_DOUBLE_EQ(filter.innovation().residual(0), 5);
  EXPECT_NEAR(filter.innovation().residual(1), 0, 1e-15);  // eq. (31) with its brackets
  EXPECT_NEAR(filter.innovation().normalised_square, 25 / (4 + 2.25), 1e-12);
  EXPECT_DOUBLE_EQ(filter.innovation().log->value, 5);
  EXPECT_NEAR(filter.innovation().log->sigma, 2.5, 1e-12);        // sqrt(4 + 2.25)
  EXPECT_NEAR(filter.state()(0), 3 + 5 * 4 / (4 + 2.25), 1e-12);  // scalar Kalman gain
  filter.update_stationary();
  EXPECT_EQ(filter.innovation().size, 4);
  EXPECT_FALSE(filter.innovation().log);
}

TEST(LevelingFilter, StraightUpItStaysFinite) {
  const LevelingFilter filter = settle(at_36_degrees(), {0, 90 * degree, 0}, 5);
  EXPECT_NEAR(filter.pitch(), 90 * degree, 1e-3);
  EXPECT_TRUE(filter.roll_pitch_covariance().allFinite());
  EXPECT_TRUE(std::isfinite(filter.heading()));
}

}  // namespace
}  // namespace drydock::leveling
