#include "estimators/navigation/sdins.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/estimators/navigation/analytic_voyage.hpp"

namespace drydock::navigation {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using test::AnalyticVoyage;

struct Largest {
  double position_m = 0, height_m = 0, velocity_mps = 0, attitude_rad = 0;
};

/// The largest error on the voyage, checked once a minute.
Largest navigate(double duration_s, int samples_a_step, bool with_loop) {
  const AnalyticVoyage voyage;
  constexpr double dt = 0.01;
  Sdins sdins(voyage.at(0), with_loop ? HeightLoop::of_time_constant(30) : HeightLoop{});
  IncrementSum sum;
  Largest largest;
  const long samples = std::lround(duration_s / dt);
  for (long k = 0; k < samples; ++k) {
    const auto sample = voyage.sample(static_cast<double>(k) * dt, dt);
    sum.add(sample.angle, sample.velocity, dt);
    const double t = static_cast<double>(k + 1) * dt;
    if (sum.samples() < samples_a_step) continue;
    const double middle = t - sum.dt() / 2;
    if (with_loop) {
      sdins.step(sum.take(), voyage.at(middle).position.height_m);
    } else {
      sdins.step(sum.take());
    }
    if ((k + 1) % 6000 != 0) continue;
    const NavigationState truth = voyage.at(t), &got = sdins.state();
    largest.position_m =
        std::max(largest.position_m, test::horizontal_distance(truth.position, got.position));
    largest.height_m =
        std::max(largest.height_m, std::abs(truth.position.height_m - got.position.height_m));
    largest.velocity_mps =
        std::max(largest.velocity_mps, (truth.velocity_ned - got.velocity_ned).norm());
    largest.attitude_rad =
        std::max(largest.attitude_rad, truth.body_to_ned.angularDistance(got.body_to_ned));
  }
  return largest;
}

TEST(Sdins, WithoutSensorErrorsStaysWithinATenthOfAMetreOverFiveAndAHalfHours) {
  const Largest error = navigate(5.5 * 3600, 10, true);
  RecordProperty("position_m", std::to_string(error.position_m));
  EXPECT_LT(error.position_m, 0.1);
  EXPECT_LT(error.height_m, 0.1);
  EXPECT_LT(error.velocity_mps, 1e-4);
  EXPECT_LT(error.attitude_rad, 1e-7);
}

TEST(Sdins, AStepASampleIsAsGood) {
  const Largest error = navigate(1800, 1, true);
  EXPECT_LT(error.position_m, 0.01);
  EXPECT_LT(error.velocity_mps, 1e-5);
  EXPECT_LT(error.attitude_rad, 1e-8);
}

TEST(Sdins, WithoutAHeightLoopTheHeightKeepsForTenMinutes) {
  EXPECT_LT(navigate(600, 10, false).height_m, 0.02);
}

TEST(Sdins, TheHeightLoopTakesOutAnErrorInHeightVelocityAndVerticalAccelerometer) {
  const AnalyticVoyage voyage;
  NavigationState start = voyage.at(0);
  start.position.height_m += 20;
  start.velocity_ned.z() += 0.5;
  Sdins sdins(start, HeightLoop::of_time_constant(30));
  for (int k = 0; k < 6000; ++k) {
    const double t = k * 0.1;
    auto sample = voyage.sample(t, 0.1);
    sample.velocity.z() += 1e-3 * 0.1;
    IncrementSum sum;
    sum.add(sample.angle, sample.velocity, 0.1);
    sdins.step(sum.take(), voyage.at(t + 0.05).position.height_m);
  }
  EXPECT_NEAR(sdins.state().position.height_m, voyage.at(600).position.height_m, 0.02);
}

TEST(Quaternion, OfARotationVectorIsThatOfAxisAndAngle) {
  for (const double angle : {0.0, 1e-9, 1e-3, 0.05, 0.19, 0.21, 1.0, 3.0}) {
    const Vector3d axis = Vector3d{1, -2, 3}.normalized();
    const Quaterniond expected{Eigen::AngleAxisd{angle, axis}};
    EXPECT_LT((quaternion_of(angle * axis).coeffs() - expected.coeffs()).norm(), 1e-15) << angle;
  }
}

TEST(Increments, ConingIsRectified) {
  // The x axis of a body moves on a cone of angle a at frequency w, without a net turn. The angle
  // of each sample is exact; the plain product of the samples is not.
  const double a = 0.02, w = 20, dt = 0.01;
  const auto attitude = [&](double t) {
    return Quaterniond{std::cos(a / 2), 0, std::sin(a / 2) * std::cos(w * t),
                       std::sin(a / 2) * std::sin(w * t)};
  };
  IncrementSum sum;
  Quaterniond reached = attitude(0), uncorrected = attitude(0);
  for (int k = 0; k < 6000; ++k) {
    const double t = k * dt;
    // The body rate of this motion: [-2 w sin^2(a/2), -w sin(a) sin(w t), w sin(a) cos(w t)].
    const Vector3d angle{-2 * w * std::pow(std::sin(a / 2), 2) * dt,
                         std::sin(a) * (std::cos(w * (t + dt)) - std::cos(w * t)),
                         std::sin(a) * (std::sin(w * (t + dt)) - std::sin(w * t))};
    sum.add(angle, Vector3d::Zero(), dt);
    uncorrected = uncorrected * quaternion_of(angle);
    if (sum.samples() == 2) reached = reached * quaternion_of(sum.take().rotation);
  }
  EXPECT_GT(uncorrected.angularDistance(attitude(60)), 5e-4);
  EXPECT_LT(reached.angularDistance(attitude(60)), 2e-5);
}

TEST(Increments, ScullingIsRectified) {
  // A roll of a sin(w t) together with a lateral specific force of b sin(w t): in fixed axes the
  // mean force is a b / 2.
  const double a = 0.01, b = 5, w = 20, dt = 0.01;
  IncrementSum sum;
  Quaterniond attitude = Quaterniond::Identity();
  Vector3d velocity = Vector3d::Zero();
  const int samples = static_cast<int>(std::lround(100 * 2 * M_PI / w / dt)) / 4 * 4;
  for (int k = 0; k < samples; ++k) {
    const double t = k * dt;
    sum.add({a * (std::sin(w * (t + dt)) - std::sin(w * t)), 0, 0},
            {0, -b / w * (std::cos(w * (t + dt)) - std::cos(w * t)), 0}, dt);
    if (sum.samples() < 4) continue;
    const Increments step = sum.take();
    velocity += attitude * step.velocity;
    attitude = attitude * quaternion_of(step.rotation);
  }
  EXPECT_NEAR(velocity.z() / (samples * dt), a * b / 2, 0.002 * a * b / 2);
}

}  // namespace
}  // namespace drydock::navigation
