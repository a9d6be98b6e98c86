#include "estimators/mixing/slip_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::mixing::slip_watch_test {
namespace {

using Eigen::Vector3d;

constexpr double dt = 0.01, gravity = 9.8, span = 3, degree = 0.0174533;

/// A level vehicle that goes straight ahead, and an estimate of its attitude that is off.
struct Level {
  SlipWatch watch{span, gravity};
  double t = 0;

  explicit Level(double speed_mps) : speed(speed_mps) { watch.start(speed_mps); }
  void step(double roll, double pitch, const Vector3d& rate = Vector3d::Zero(),
            double sideways = 0) {
    const Vector3d force{0, rate.z() * speed + sideways, -gravity - rate.y() * speed};
    const Vector3d down{-std::sin(pitch), std::sin(roll) * std::cos(pitch),
                        std::cos(roll) * std::cos(pitch)};
    watch.step(force, rate, down, speed, dt);
    t += dt;
  }
  double speed;
};

TEST(SlipWatch, ARollThatIsWrongGivesAVelocityOfItsSpan) {
  Level level(0);
  for (int i = 0; i < 3000; ++i) level.step(1 * degree, 0);
  EXPECT_NEAR(level.watch.slip().y(), gravity * std::sin(1 * degree) * span, 1e-3);
  EXPECT_NEAR(level.watch.slip().x(), 0, 1e-12);
}

TEST(SlipWatch, ABiasOfAGyroIsSeenWhenItsClosedFormSays) {
  // The roll is b t: slip = g b (T t - T^2 (1 - e^(-t/T))). It is seen at 5.33 x .03 m/s.
  constexpr double bias = 1 * degree;
  Level level(5);
  while (!level.watch.contradicts(0) && level.t < 10) level.step(bias * level.t, 0);
  const double t = level.t;
  EXPECT_NEAR(gravity * bias * (span * t - span * span * -std::expm1(-t / span)),
              SlipWatch::limit * 0.03, 0.01);
  EXPECT_NEAR(t, 1.5, 0.1);
}

TEST(SlipWatch, AStepOfATenthOfASecondSeesTheSameBiasATenthLaterAtMost) {
  // The same closed form: the roll at the end of a step stands for all of it.
  constexpr double bias = 1 * degree, step = 0.1;
  SlipWatch watch(span, gravity);
  watch.start(0);
  double t = 0;
  while (!watch.contradicts(0) && t < 10) {
    t += step;
    watch.step({0, 0, -gravity}, Vector3d::Zero(), {0, std::sin(bias * t), std::cos(bias * t)}, 0,
               step);
  }
  const auto slip_at = [&](double at) {
    return gravity * bias * (span * at - span * span * -std::expm1(-at / span));
  };
  EXPECT_GT(slip_at(t), SlipWatch::limit * 0.03 * 0.9);
  EXPECT_LT(slip_at(t - step), SlipWatch::limit * 0.03);
}

TEST(SlipWatch, APitchThatIsWrongShowsAheadUnlessTheLogSaysTheSame) {
  Level level(5);
  for (int i = 0; i < 300; ++i) level.step(0, -3 * degree);
  EXPECT_TRUE(level.watch.contradicts(0));

  SlipWatch watch(span, gravity);  // a vehicle that gains .5 m/s2, as its log says
  watch.start(2);
  for (int i = 1; i <= 600; ++i)
    watch.step({0.5, 0, -gravity}, Vector3d::Zero(), Vector3d::UnitZ(), 2 + 0.5 * i * dt, dt);
  EXPECT_FALSE(watch.contradicts(0));
}

TEST(SlipWatch, AnAttitudeThatIsLittleKnownMayBeOffAsMuch) {
  Level level(0);
  for (int i = 0; i < 3000; ++i) level.step(1 * degree, 0);
  EXPECT_TRUE(level.watch.contradicts(0.1 * degree));
  EXPECT_FALSE(level.watch.contradicts(0.2 * degree));
}

TEST(SlipWatch, AVehicleThatBeginsToTurnSlips) {
  // About a point 2.5 m ahead: at .1 rad/s by .25 m/s, which it gains within a second.
  Level level(6);
  for (int i = 0; i < 3000; ++i) {
    const double rate = std::min(0.1, 0.1 * level.t);
    level.step(0, 0, {0, 0, rate}, level.t < 1 ? -0.25 : 0);
    ASSERT_FALSE(level.watch.contradicts(0)) << level.t;
  }
}

TEST(SlipWatch, NumbersThatAreNoneContradict) {
  Level level(0);
  level.step(std::nan(""), 0);
  EXPECT_TRUE(level.watch.contradicts(0));
}

}  // namespace
}  // namespace drydock::mixing::slip_watch_test
