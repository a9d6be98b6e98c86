#include "estimators/smoothing/singer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::smoothing {
namespace {

using Eigen::Matrix3d;

/// Singer (1970) gives the acceleration as white noise of density 2 sigma2 / tau through a first
/// order lag. This integrates the covariance equation P' = F P + P F' + Q with steps of `h`.
SingerStep integrated(double density, double tau, double duration_s, double h) {
  Matrix3d f;
  f << 0, 1, 0, 0, 0, 1, 0, 0, -1 / tau;
  Matrix3d q = Matrix3d::Zero();
  q(2, 2) = density * density / (tau * tau);
  const auto slope = [&](const Matrix3d& p) -> Matrix3d { return f * p + p * f.transpose() + q; };
  SingerStep step{Matrix3d::Identity(), Matrix3d::Zero()};
  const int steps = static_cast<int>(std::lround(duration_s / h));
  for (int i = 0; i < steps; ++i) {
    Matrix3d& p = step.noise;
    const Matrix3d a = slope(p), b = slope(p + h / 2 * a), c = slope(p + h / 2 * b),
                   d = slope(p + h * c);
    p += h / 6 * (a + 2 * b + 2 * c + d);
    const Matrix3d x = h * f;
    step.transition = (Matrix3d::Identity() + x + x * x / 2 + x * x * x / 6 + x * x * x * x / 24) *
                      step.transition;
  }
  return step;
}

TEST(SingerStep, EqualsTheIntegralOfItsDifferentialEquation) {
  for (const double dt : {0.01, 0.039, 0.041, 0.5, 2.0, 30.0}) {
    const auto step = singer_step(0.1, 2, dt);
    const auto exact = integrated(0.1, 2, dt, dt / 4000);
    EXPECT_LT((step.transition - exact.transition).norm(), 1e-5 * exact.transition.norm()) << dt;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(step.noise(i, j) / exact.noise(i, j), 1, 0.03) << dt << ' ' << i << ' ' << j;
  }
}

TEST(SingerStep, TwoStepsAreOneOfTheirSum) {
  const auto first = singer_step(0.2, 3, 0.7), second = singer_step(0.2, 3, 1.9);
  const auto both = singer_step(0.2, 3, 2.6);
  EXPECT_LT((second.transition * first.transition - both.transition).norm(), 1e-12);
  const Matrix3d noise =
      second.transition * first.noise * second.transition.transpose() + second.noise;
  EXPECT_LT((noise - both.noise).norm(), 1e-12);
}

/// Of a random walk: q2 dt for the rate, q2 dt3 / 3 for the value.
TEST(SingerStep, OfAShortCorrelationIsARandomWalkOfTheRate) {
  const double q = 0.1, dt = 100;
  const auto step = singer_step(q, 1e-3, dt);
  EXPECT_NEAR(step.noise(1, 1), q * q * dt, 1e-4 * q * q * dt);
  EXPECT_NEAR(step.noise(0, 1), q * q * dt * dt / 2, 1e-4 * q * q * dt * dt);
  EXPECT_NEAR(step.noise(0, 0), q * q * dt * dt * dt / 3, 1e-4 * q * q * dt * dt * dt);
}

TEST(SingerStep, TheAccelerationKeepsItsVariance) {
  const double sigma = singer_acceleration(0.1, 2);
  const auto step = singer_step(0.1, 2, 1.3);
  const double kept = step.transition(2, 2);
  EXPECT_NEAR(kept * kept * sigma * sigma + step.noise(2, 2), sigma * sigma, 1e-15);
}

}  // namespace
}  // namespace drydock::smoothing
