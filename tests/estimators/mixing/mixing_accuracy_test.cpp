#include "estimators/mixing/mixing_accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::mixing::mixing_accuracy_test {
namespace {

constexpr double dt = 0.01;

double after(const SensorAccuracy& sensors, double k1, double ki, double leak, double seconds) {
  MixingAccuracy accuracy(sensors);
  accuracy.start(false);
  for (double t = 0; t < seconds; t += dt) accuracy.step(k1, ki, leak, dt);
  return std::sqrt(accuracy.variance());
}

TEST(MixingAccuracy, AConstantVerticalErrorComesThroughWhole) {
  EXPECT_NEAR(after({2e-3, 0, 0, 0.1}, 0.1, 0.001, 0, 4000), 2e-3, 1e-8);
}

TEST(MixingAccuracy, WhiteNoiseOfTheGyroEndsAtItsClosedForm) {
  // d(e) = -K1 e + n: sigma = q / sqrt(2 K1). For the discrete loop divide by sqrt(1 - K1 dt / 2).
  EXPECT_NEAR(after({0, 0, 1e-3, 0}, 0.1, 0, 0, 400), 1e-3 / std::sqrt(0.2), 2e-6);
}

TEST(MixingAccuracy, AGyroBiasIsTakenOutByAnIntegralThatForgetsNothing) {
  EXPECT_NEAR(after({0, 1e-4, 0, 0}, 0.1, 0, 0, 400), 1e-3, 1e-9);  // bias / K1
  EXPECT_NEAR(after({0, 1e-4, 0, 0}, 0.1, 0.001, 0, 4000), 0, 1e-8);
  // With a decay at the rate c: bias c / (K1 c + KI).
  EXPECT_NEAR(after({0, 1e-4, 0, 0}, 0.1, 0.001, 0.02, 4000), 1e-4 * 0.02 / 0.003, 1e-9);
}

TEST(MixingAccuracy, WithoutGainsAFreeGyroDrifts) {
  EXPECT_NEAR(after({0, 1e-4, 0, 0}, 0, 0, 0, 100), 1e-2, 2e-6);
}

TEST(MixingAccuracy, NoiseBeyondThatOfTheSensorCountsAsItsOwn) {
  // q^2 and 3 q^2 more are the loop of a gyro with 2 q: sigma = 2 q / sqrt(2 K1).
  constexpr double q = 1e-3;
  MixingAccuracy accuracy({0, 0, q, 0});
  accuracy.start(false);
  for (double t = 0; t < 400; t += dt) {
    accuracy.step(0.1, 0, 0, dt);
    accuracy.add_gyro_noise(3 * q * q, dt);
  }
  EXPECT_NEAR(std::sqrt(accuracy.variance()), 2 * q / std::sqrt(0.2), 4e-6);
}

TEST(MixingAccuracy, AgainstItsVerticalItIsNotOffByTheVerticalsError) {
  MixingAccuracy accuracy({2e-3, 0, 1e-4, 0.1});
  accuracy.start(true);
  EXPECT_NEAR(accuracy.variance_to_vertical(), 0, 1e-15);
  for (double t = 0; t < 400; t += dt) accuracy.step(0.1, 0, 0, dt);
  EXPECT_NEAR(std::sqrt(accuracy.variance_to_vertical()), 1e-4 / std::sqrt(0.2), 1e-6);
}

TEST(MixingAccuracy, AStartByAccelerometersHasTheirErrorFromTheFirst) {
  MixingAccuracy accuracy({2e-3, 0, 0, 0.1});
  accuracy.start(true);
  for (int i = 0; i < 100; ++i) accuracy.step(0.1, 0.001, 0, dt);
  EXPECT_NEAR(std::sqrt(accuracy.variance()), 2e-3, 1e-12);
}

}  // namespace
}  // namespace drydock::mixing::mixing_accuracy_test
