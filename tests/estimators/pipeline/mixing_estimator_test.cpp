#include "estimators/pipeline/mixing_estimator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/estimators/pipeline/vehicle_ahead.hpp"

namespace drydock::pipeline::mixing_estimator_test {
namespace {

PipelineOptions mixing_on(mixing::MixingType type) {
  auto options = test::moving(std::chrono::milliseconds{0});
  auto& mixing = options.estimators[0].kind.emplace<MixingOptions>();
  mixing.log = test::log_device;
  mixing.filter.type = type;
  return options;
}

TEST(MixingEstimator, WaitsForASpeedAndThenGivesAnEstimateForEveryImuSample) {
  test::Estimates estimates;
  auto pipeline = make_pipeline(mixing_on(mixing::MixingType::compensated), estimates);
  pipeline->receive(test::imu(0));
  EXPECT_EQ(pipeline->status(0).state, EstimatorState::waiting_for_speed);
  EXPECT_TRUE(estimates.all.empty());
  pipeline->receive(test::water_speed(5));
  for (int t = 10; t <= 1000; t += 10) pipeline->receive(test::imu(t));
  ASSERT_EQ(estimates.all.size(), 100U);
  EXPECT_EQ(estimates.all.back().valid_at, test::at_ms(1000));
  EXPECT_EQ(estimates.all.back().fed_by, 1U << test::imu_device | 1U << test::log_device);
  EXPECT_FALSE(estimates.all.back().yaw_rad.has_value());
}

TEST(MixingEstimator, IsTheFilterOnTheMeansBetweenSamples) {
  test::Estimates estimates;
  const auto options = mixing_on(mixing::MixingType::fuzzy_inference);
  auto pipeline = make_pipeline(options, estimates);
  mixing::MixingFilter filter(std::get<MixingOptions>(options.estimators[0].kind).filter);
  pipeline->receive(test::water_speed(0, 3));
  const auto at = [](int k) { return test::imu(10 * k, 0.1 * std::sin(0.05 * k)); };
  pipeline->receive(at(0));
  filter.start(at(0).specific_force, at(0).angular_rate, 3);
  for (int k = 1; k < 500; ++k) {
    pipeline->receive(at(k));
    filter.step((at(k - 1).specific_force + at(k).specific_force) / 2,
                (at(k - 1).angular_rate + at(k).angular_rate) / 2, 3, 0.01);
  }
  EXPECT_NEAR(estimates.all.back().roll_rad, filter.roll(), 1e-12);
  EXPECT_NEAR(estimates.all.back().pitch_rad, filter.pitch(), 1e-12);
}

TEST(MixingEstimator, ItsCovarianceIsTheLoopsAnswerToKnownSensors) {
  test::Estimates estimates;
  const auto options = mixing_on(mixing::MixingType::compensated);
  auto pipeline = make_pipeline(options, estimates);
  pipeline->receive(test::water_speed(0));
  for (int t = 0; t <= 600'000; t += 10) pipeline->receive(test::imu(t));
  // At level 1, K1 = 0.1: the error of the vertical, and the noise of the gyro q / sqrt(2 K1),
  // without the part of the integral.
  const mixing::SensorAccuracy sensors;
  const double expected = std::hypot(sensors.vertical_rad, sensors.gyro_noise / std::sqrt(0.2));
  EXPECT_NEAR(std::sqrt(estimates.all.back().covariance(1, 1)), expected, 0.05 * expected);
  EXPECT_GE(estimates.all.back().covariance(0, 0), estimates.all.back().covariance(1, 1));
  EXPECT_EQ(estimates.all.back().covariance(0, 1), 0);
}

/// The largest change of roll and pitch by one speed of 20 m/s among speeds of 2 m/s in a turn.
double pulled_by_an_outlier_deg(mixing::MixingType type) {
  test::Estimates spoilt, clean;
  for (auto* estimates : {&spoilt, &clean}) {
    auto pipeline = make_pipeline(mixing_on(type), *estimates);
    for (int t = 0; t <= 120'000; t += 10) {
      const bool outlier = estimates == &spoilt && t == 90'000;
      if (t % 500 == 0) pipeline->receive(test::water_speed(t, outlier ? 20 : 2));
      pipeline->receive(test::imu(t, 0.002));
    }
    EXPECT_EQ(pipeline->status(0).rejected, 0U);
  }
  double most = 0;
  for (std::size_t i = 0; i < clean.all.size(); ++i)
    most = std::max({most, std::abs(spoilt.all[i].roll_rad - clean.all[i].roll_rad),
                     std::abs(spoilt.all[i].pitch_rad - clean.all[i].pitch_rad)});
  return most * 180 / std::numbers::pi;
}

TEST(MixingEstimator, HasNoGateButASingleWrongSpeedIsSmallAgainstItsErrors) {
  EXPECT_LT(pulled_by_an_outlier_deg(mixing::MixingType::fixed_gain), 0.02);
  EXPECT_LT(pulled_by_an_outlier_deg(mixing::MixingType::fuzzy_inference), 0.05);
  EXPECT_LT(pulled_by_an_outlier_deg(mixing::MixingType::gain_schedule), 0.05);
  EXPECT_LT(pulled_by_an_outlier_deg(mixing::MixingType::compensated), 0.1);
}

TEST(MixingEstimator, WithoutASpeedLogItIsRefusedInOneLine) {
  test::Estimates estimates;
  auto options = mixing_on(mixing::MixingType::compensated);
  std::get<MixingOptions>(options.estimators[0].kind).log.reset();
  EXPECT_EQ(make_pipeline(options, estimates).error().message,
            "estimator 'attitude': mixing needs a speed log, allowed: log = a device");
}

TEST(MixingEstimator, NoiseThatBeginsIsInTheCovarianceFromItsFirstSamplesOn) {
  // White noise s of samples T apart turns the attitude by a random walk of variance s^2 T^2 a
  // sample. It is learned as a mean over 100 samples, so what was learned adds up to less than half
  // of that in the first 150. The gain .1 takes a quarter of it off at most.
  constexpr double sheet = 4.363e-3, noise = 0.012, period_s = 0.01;  // rad/s a sample
  test::Ahead bench(test::mixing_kind());
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  const auto run = [&](int samples, double sigma) {
    for (int i = 0; i < samples; ++i) {
      for (double& rate : bench.rate_error) rate = sigma * normal(random);
      bench.run(period_s);
    }
    return bench.estimates.all.back().covariance(1, 1);
  };
  const double before = run(6000, sheet), after = run(150, noise);
  const double expected = 150 * std::pow(noise * period_s, 2);
  EXPECT_GT(after - before, 0.6 * expected);
  EXPECT_LT(after - before, 1.3 * expected);
}

}  // namespace
}  // namespace drydock::pipeline::mixing_estimator_test
