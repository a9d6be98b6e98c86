#include "estimators/navigation/aided_navigation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "estimators/frame/local_earth.hpp"
#include "tests/estimators/navigation/analytic_voyage.hpp"
#include "tests/estimators/pipeline/counting_new.hpp"

namespace drydock::navigation {
namespace {

using Eigen::Vector3d;
using test::AnalyticVoyage;

/// A tactical-grade IMU on the analytic voyage, with errors drawn from `options`.
struct Bench {
  std::mt19937_64 random{7};
  NavigationOptions options;
  AnalyticVoyage voyage;
  Vector3d gyro_bias, accel_bias;

  explicit Bench(std::uint64_t seed) : random(seed) {
    options.alignment_rad = {1e-3, 1e-3, 3e-3};
    options.gyro_bias_radps = 5e-6;
    options.accel_bias_mps2 = 5e-3;
    options.angle_noise_rad = 1e-5;
    options.velocity_noise_mps = 1e-4;
    options.height_loop_tau_s = 0;
    options.height_noise_m = 0;
    gyro_bias = normal3(options.gyro_bias_radps);
    accel_bias = normal3(options.accel_bias_mps2);
  }

  double normal(double sigma) { return std::normal_distribution<double>(0, sigma)(random); }
  Vector3d normal3(double sigma) { return {normal(sigma), normal(sigma), normal(sigma)}; }

  NavigationState wrong_start() {
    NavigationState start = voyage.at(0);
    const frame::LocalEarth earth = frame::local_earth(start.position.latitude_rad, 0);
    start.position.latitude_rad += normal(options.position_m) / earth.meridian_radius_m;
    start.position.longitude_rad +=
        normal(options.position_m) / (earth.transverse_radius_m * earth.cos_latitude);
    start.position.height_m += normal(options.height_m);
    start.velocity_ned += normal3(options.velocity_mps);
    const Vector3d tilt = normal3(1).cwiseProduct(options.alignment_rad);
    start.body_to_ned = quaternion_of(-tilt) * start.body_to_ned;
    return start;
  }

  /// Ten samples of 10 ms and a step.
  void step(AidedNavigation& navigation, double t) {
    for (int i = 0; i < 10; ++i) {
      const auto sample = voyage.sample(t + i * 0.01, 0.01);
      navigation.add_imu(
          sample.angle + gyro_bias * 0.01 + normal3(options.angle_noise_rad * 0.1),
          sample.velocity + accel_bias * 0.01 + normal3(options.velocity_noise_mps * 0.1), 0.01);
    }
    navigation.step();
  }

  /// A velocity (1 sigma 3 cm/s an axis) and a height (0.5 m) each second.
  void sail_20_s_with_velocity_and_height(AidedNavigation& navigation) {
    for (int k = 0; k < 200; ++k) {
      step(navigation, k * 0.1);
      if (k % 10 != 9) continue;
      const NavigationState truth = voyage.at((k + 1) * 0.1);
      const Vector3d body = truth.body_to_ned.conjugate() * truth.velocity_ned;
      navigation.update_velocity(body + normal3(0.03), Vector3d::Constant(0.03));
      navigation.update_height(truth.position.height_m + normal(0.5), 0.5);
    }
  }
};

TEST(AidedNavigation, NoiseOfASampleJoinsTheCovarianceTurnedFromBodyAxes) {
  NavigationState start = AnalyticVoyage{}.at(0);
  start.body_to_ned = quaternion_of({0, 0, M_PI / 2});  // forward is east, starboard south
  AidedNavigation aided{start, {}};
  const Eigen::MatrixXd before = aided.covariance();
  aided.add_noise({1e-3, 2e-3, 3e-3}, {0.1, 0.2, 0.3});
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(before.rows(), before.cols());
  expected.diagonal().segment<3>(velocity_error) << 0.04, 0.01, 0.09;
  expected.diagonal().segment<3>(phi) << 4e-6, 1e-6, 9e-6;
  EXPECT_LT((aided.covariance() - before - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(AidedNavigation, FindsPositionVelocityAttitudeAndBiasesFromPositions) {
  Bench bench(1);
  AidedNavigation navigation(bench.wrong_start(), bench.options);
  for (int k = 0; k < 1500; ++k) {
    bench.step(navigation, k * 0.1);
    if (k % 10 != 9) continue;
    frame::Position seen = bench.voyage.at((k + 1) * 0.1).position;
    seen.latitude_rad += bench.normal(0.02) / 6.37e6;
    seen.longitude_rad += bench.normal(0.02) / 5.1e6;
    seen.height_m += bench.normal(0.03);
    EXPECT_EQ(navigation.update_position(seen, {0.02, 0.02, 0.03}), 3);
  }
  const NavigationState truth = bench.voyage.at(150);
  EXPECT_LT(test::horizontal_distance(truth.position, navigation.state().position), 0.05);
  EXPECT_LT((truth.velocity_ned - navigation.state().velocity_ned).norm(), 0.02);

  // The errors of attitude and biases agree with the covariance (99.9 % of chi-square, 9 degrees of
  // freedom).
  Eigen::Matrix<double, 9, 1> error;
  const Eigen::AngleAxisd turn(navigation.state().body_to_ned * truth.body_to_ned.conjugate());
  error << -turn.angle() * turn.axis(), bench.gyro_bias - navigation.gyro_bias(),
      bench.accel_bias - navigation.accel_bias();
  const Eigen::Matrix<double, 9, 9> covariance = navigation.covariance().block<9, 9>(6, 6);
  EXPECT_LT(error.dot(covariance.ldlt().solve(error)), 27.9);
  EXPECT_LT(covariance(3, 3), 0.5 * std::pow(bench.options.gyro_bias_radps, 2));
}

TEST(AidedNavigation, VelocityAndHeightErrorsAreAsLargeAsItsCovarianceSays) {
  // 3 axes and 12 voyages: in 95 % of such tests the mean normalised square is 3 +- 1.4.
  double square = 0;
  constexpr int voyages = 12;
  for (int run = 0; run < voyages; ++run) {
    Bench bench(100 + run);
    AidedNavigation navigation(bench.wrong_start(), bench.options);
    bench.sail_20_s_with_velocity_and_height(navigation);
    const Vector3d error = navigation.state().velocity_ned - bench.voyage.at(20).velocity_ned;
    const Eigen::Matrix3d covariance = navigation.covariance().block<3, 3>(3, 3);
    square += error.dot(covariance.ldlt().solve(error));
  }
  EXPECT_NEAR(square / voyages, 3, 1.4);
}

TEST(AidedNavigation, ItsInnovationsAreAsLargeAsItExpects) {
  // 12 voyages with 20 times 3 + 1 rows: in 99.7 % of such tests the mean of the 960 squares is
  // 1 +- 0.14.
  InnovationTally taken;
  for (int run = 0; run < 12; ++run) {
    Bench bench(200 + run);
    AidedNavigation navigation(bench.wrong_start(), bench.options);
    bench.sail_20_s_with_velocity_and_height(navigation);
    taken = taken + navigation.taken();
  }
  EXPECT_EQ(taken.count, 960u);
  EXPECT_NEAR(*taken.mean(), 1, 0.14);
  EXPECT_FALSE((taken - taken).mean());
}

TEST(AidedNavigation, TheGateRefusesAnOutlierAndSaysSo) {
  Bench bench(3);
  bench.options.gate_sigma = 4;
  AidedNavigation navigation(bench.voyage.at(0), bench.options);
  bench.step(navigation, 0);
  const NavigationState before = navigation.state();
  const Vector3d body = before.body_to_ned.conjugate() * before.velocity_ned;
  EXPECT_EQ(navigation.update_velocity(body + Vector3d{5, 0, 0}, Vector3d::Constant(0.03)), 2);
  EXPECT_GT(navigation.innovation_square(), 1000);
  EXPECT_EQ(navigation.innovations().size(), 3u);
  EXPECT_EQ(navigation.taken().count, 2u);
  EXPECT_LT(navigation.taken().squares, 1);
  EXPECT_NEAR(navigation.state().velocity_ned.x(), before.velocity_ned.x(), 1e-6);
}

TEST(AidedNavigation, AllocatesNothing) {
  Bench bench(4);
  AidedNavigation navigation(bench.voyage.at(0), bench.options);
  const auto before = pipeline::test::allocations();
  for (int k = 0; k < 10; ++k) bench.step(navigation, k * 0.1);
  navigation.update_velocity({1, 0, 0}, Vector3d::Constant(0.03));
  navigation.update_height(-100, 0.5);
  navigation.update_position(navigation.state().position, {1, 1, 1});
  EXPECT_EQ(pipeline::test::allocations(), before);
}

}  // namespace
}  // namespace drydock::navigation
