#include "estimators/leveling/augmented_leveling_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "estimators/leveling/leveling_filter.hpp"
#include "tests/estimators/leveling/s_path.hpp"

namespace drydock::leveling {
namespace {

using Eigen::Vector3d;
using test::degree;
using test::dt;
using test::Reading;
using test::SPath;

constexpr double milli_g = 9.80665e-3, degree_per_hour = degree / 3600;

LevelingOptions augmented_options() {
  auto options = options_for(FilterKind::augmented);
  options.latitude_rad = test::latitude;
  return options;
}

template <class Filter>
void sail(Filter& filter, const SPath& path, test::Table1Sensors& sensors, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / dt));
  for (int i = 0; i < steps; ++i) {
    const Reading r = sensors(path.at(i * dt));
    if (i == 0) filter.start(r.specific_force, r.angular_rate, r.speed);
    filter.predict(r.specific_force, r.angular_rate, dt);
    filter.update_nonholonomic(dt);
    filter.update_moving(r.speed);
  }
}

TEST(AugmentedLevelingFilter, SureOfItsSensorsItIsTheFilterOfSixStates) {
  LevelingOptions options = augmented_options();
  options.accelerometer_bias_sigma_mps2 = options.gyro_bias_sigma_radps =
      options.speed_bias_sigma_mps = 0;
  AugmentedLevelingFilter thirteen{options};
  LevelingFilter six{options};
  test::Table1Sensors sensors{3}, the_same{3};
  sail(thirteen, SPath{}, sensors, 20);
  sail(six, SPath{}, the_same, 20);
  // The filter with 13 states uses the measurements one after the other, so it linearises |alpha|^2
  // at a slightly different state.
  EXPECT_NEAR(thirteen.roll(), six.roll(), 1e-6);
  EXPECT_NEAR(thirteen.pitch(), six.pitch(), 1e-6);
  EXPECT_LT((thirteen.covariance().topLeftCorner<6, 6>() - six.covariance()).norm(),
            1e-4 * six.covariance().norm());
  EXPECT_EQ(thirteen.state().tail<7>().norm(), 0);
}

TEST(AugmentedLevelingFilter, BiasesMoveTheStateAsWrongInputsDo) {
  // A bias b in the state has the same effect as inputs that are too large by b: eq. (A1). So after
  // one step the covariance of motion with bias is the variance of the bias times d x / d b. Here
  // differences of the inputs give d x / d b.
  const Vector3d force{0.3, -0.4, -9.7}, rate{0.1, -0.2, 0.15};
  const auto moved = [&](const Vector3d& f, const Vector3d& w) -> Vector6 {
    AugmentedLevelingFilter filter{augmented_options()};
    filter.start(force, rate, 8);
    filter.predict(f, w, dt);
    return filter.state().head<6>();
  };
  AugmentedLevelingFilter filter{augmented_options()};
  filter.start(force, rate, 8);
  filter.predict(force, rate, dt);
  const double h = 1e-4;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d e = h * Vector3d::Unit(axis);
    const Vector6 by_force = (moved(force - e, rate) - moved(force + e, rate)) / (2 * h);
    const Vector6 by_rate = (moved(force, rate - e) - moved(force, rate + e)) / (2 * h);
    const Vector6 force_cross = filter.covariance().block<6, 1>(0, 6 + axis);
    const Vector6 rate_cross = filter.covariance().block<6, 1>(0, 9 + axis);
    EXPECT_LT((force_cross / (milli_g * milli_g) - by_force).norm(), 1e-3 * by_force.norm());
    EXPECT_LT((rate_cross / (degree_per_hour * degree_per_hour) - by_rate).norm(),
              1e-2 * by_rate.norm());
  }
}

TEST(AugmentedLevelingFilter, ATurningVehicleTellsTheBiasesOfAccelerometersAndLog) {
  test::Table1Sensors sensors{11};
  sensors.fix_biases_at_one_sigma();
  AugmentedLevelingFilter filter{augmented_options()};
  sail(filter, SPath{}, sensors, 120);
  EXPECT_NEAR(filter.accelerometer_bias().x(), milli_g, 0.15 * milli_g);
  EXPECT_NEAR(filter.accelerometer_bias().y(), milli_g, 0.15 * milli_g);
  EXPECT_NEAR(filter.speed_bias(), 0.1, 0.03);
  EXPECT_NEAR(filter.roll(), 0, 0.01 * degree);
  EXPECT_NEAR(filter.pitch(), 0, 0.01 * degree);
  const auto sigma = filter.covariance().diagonal().cwiseSqrt().eval();
  EXPECT_LT(sigma(6), 0.2 * milli_g);
  EXPECT_LT(sigma(7), 0.2 * milli_g);
}

TEST(AugmentedLevelingFilter, AtRestATiltAndABiasLookTheSameAndItKnows) {
  // At rest -b_y / g and roll have the same effect: both keep the uncertainty of the bias, 1 mg.
  AugmentedLevelingFilter filter{augmented_options()};
  const Reading rest = SPath{0, 0, 30}.at(0);
  filter.start(rest.specific_force, rest.angular_rate, 0);
  for (int i = 0; i < 6000; ++i) {
    filter.predict(rest.specific_force, rest.angular_rate, dt);
    filter.update_stationary();
  }
  const auto covariance = filter.roll_pitch_covariance();
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), 1e-3, 2e-5);
  EXPECT_NEAR(std::sqrt(covariance(1, 1)), 1e-3, 2e-5);
  EXPECT_NEAR(std::sqrt(filter.covariance()(6, 6)), milli_g, 0.02 * milli_g);
  EXPECT_NEAR(std::sqrt(filter.covariance()(7, 7)), milli_g, 0.02 * milli_g);
}

TEST(AugmentedLevelingFilter, CovarianceStaysSymmetricAndPositiveForFiveMinutes) {
  test::Table1Sensors sensors{7};
  AugmentedLevelingFilter filter{augmented_options()};
  for (int part = 0; part < 10; ++part) {
    sail(filter, SPath{}, sensors, 30);
    const auto& p = filter.covariance();
    EXPECT_EQ(p, p.transpose());
    // Scaled by the sigmas, because the states have different units.
    const AugmentedLevelingFilter::State scale = p.diagonal().cwiseSqrt().cwiseInverse();
    const AugmentedLevelingFilter::Covariance correlation =
        scale.asDiagonal() * p * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<AugmentedLevelingFilter::Covariance> solver{correlation};
    EXPECT_GT(solver.eigenvalues()(0), 0);
  }
}

TEST(AugmentedLevelingFilter, InnovationOfTheLogCountsItsBias) {
  LevelingOptions options = augmented_options();
  options.initial_velocity_sigma_mps = 2;
  options.speed_bias_sigma_mps = 1;
  options.speed_sigma_mps = 1.5;
  AugmentedLevelingFilter filter{options};
  filter.start({0, 0, -9.8}, Vector3d::Zero(), 3);
  filter.update_moving(8);
  EXPECT_EQ(filter.innovation().size, 2);
  EXPECT_DOUBLE_EQ(filter.innovation().residual(0), 5);
  const double expected = 4 + 1 + 2.25;
  EXPECT_NEAR(filter.innovation().normalised_square, 25 / expected, 1e-12);
  EXPECT_NEAR(filter.innovation().log->normalised_square(), 25 / expected, 1e-12);
  EXPECT_NEAR(filter.state()(0), 3 + 5 * 4 / expected, 1e-12);
  EXPECT_NEAR(filter.speed_bias(), 5 * 1 / expected, 1e-12);
  filter.update_stationary();
  EXPECT_EQ(filter.innovation().size, 4);
}

TEST(AugmentedLevelingFilter, StartsWithoutKnowledgeOfTheBiasesHoweverOftenItIsStarted) {
  test::Table1Sensors sensors{5};
  sensors.fix_biases_at_one_sigma();
  AugmentedLevelingFilter filter{augmented_options()};
  sail(filter, SPath{}, sensors, 30);
  EXPECT_NE(filter.speed_bias(), 0);
  filter.start({0, 0, -9.8}, Vector3d::Zero(), 3);
  EXPECT_EQ(filter.state().tail<7>().norm(), 0);
  EXPECT_NEAR(filter.covariance()(12, 12), 0.01, 1e-15);
}

TEST(AugmentedLevelingFilter, StraightUpItStaysFinite) {
  AugmentedLevelingFilter filter{augmented_options()};
  const Reading up = SPath{0, 0, 30, 0, 90 * degree, 0}.at(0);
  filter.start(up.specific_force, up.angular_rate, 0);
  for (int i = 0; i < 500; ++i) {
    filter.predict(up.specific_force, up.angular_rate, dt);
    filter.update_stationary();
  }
  EXPECT_NEAR(filter.pitch(), 90 * degree, 1e-3);
  EXPECT_TRUE(filter.roll_pitch_covariance().allFinite());
  EXPECT_TRUE(std::isfinite(filter.heading()));
}

}  // namespace
}  // namespace drydock::leveling
