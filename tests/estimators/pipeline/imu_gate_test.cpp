#include "estimators/pipeline/imu_gate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline {
namespace {

using Verdict = ImuGate::Verdict;

/// A vehicle that sways by 10 degrees in 6 s, and an IMU of 100 Hz with noise of a MEMS unit:
/// 0.1 deg/s and 0.02 m/s2 a sample.
class Sway {
 public:
  Verdict next(const Eigen::Vector3d& rate_error = Eigen::Vector3d::Zero(),
               const Eigen::Vector3d& force_error = Eigen::Vector3d::Zero()) {
    auto sample = test::imu(10L * tick_++);
    const double t = 0.01 * static_cast<double>(tick_), w = 2 * std::numbers::pi / 6;
    sample.angular_rate = {0.1745 * w * std::cos(w * t), 0.01 * std::sin(t), 0.05};
    sample.angular_rate += rate_error + 1.745e-3 * noise();
    sample.specific_force += force_error + 0.02 * noise();
    if (stuck)
      sample.specific_force = said_.specific_force, sample.angular_rate = said_.angular_rate;
    said_ = sample;
    return gate.judge(sample);
  }
  /// The number of samples that are not good.
  int run(double seconds, const Eigen::Vector3d& rate_error = Eigen::Vector3d::Zero()) {
    int odd = 0;
    for (long i = std::lround(100 * seconds); i > 0; --i) odd += next(rate_error) != Verdict::good;
    return odd;
  }

  ImuGate gate{VehicleLimits{}};
  bool stuck = false;

 private:
  Eigen::Vector3d noise() { return {normal_(random_), normal_(random_), normal_(random_)}; }

  std::mt19937_64 random_{3};
  std::normal_distribution<double> normal_;
  long tick_ = 0;
  measurement::ImuSample said_;
};

constexpr double degree = 0.0174533;

TEST(ImuGate, TakesEverySampleOfASoundImu) {
  // Its margin is 6.4 sigmas of a difference: 1.6e-10 for each of 6 x 360 000 values.
  Sway sway;
  EXPECT_EQ(sway.run(3600), 0);
}

TEST(ImuGate, RefusesSingleWildRatesAndForcesAndTakesTheNextSample) {
  Sway sway;
  sway.run(10);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(sway.next({100 * degree, 0, 0}), Verdict::wild) << i;
    EXPECT_EQ(sway.next(), Verdict::good) << i;
    EXPECT_EQ(sway.next({0, 0, 0}, {0, 0, 4}), Verdict::wild) << i;
    EXPECT_EQ(sway.next(), Verdict::good) << i;
  }
}

TEST(ImuGate, ASampleThatIsOffByAlmostTheLimitIsNotThePlaceThatAStepIsCountedFrom) {
  // The limit is 8 m = 8 x 2 s / sqrt(pi) = .0158 rad/s. A sample that is off by a little less is
  // good, and the next ones, which are right, can be beyond the limit from there.
  Sway sway;
  sway.run(10);
  int off_and_good = 0, steps = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    off_and_good += sway.next({0.0150, 0, 0}) == Verdict::good;
    for (int i = 0; i < 99; ++i) {
      const bool stepped = sway.next() == Verdict::stepped;
      steps += stepped && !sway.gate.step().rate.isZero(0);
    }
  }
  EXPECT_GT(off_and_good, 1000);
  EXPECT_EQ(steps, 0);
}

TEST(ImuGate, TakesSamplesThatGoOnToLeapForNoiseAndNoStep) {
  // The eighth sample elsewhere ends the run. Those of a step are as quiet as before it; these
  // change by .012 rad/s each time, six times the usual .002.
  constexpr double leap = 10 * degree, restless = 0.006;
  Sway sway;
  sway.run(10);
  for (int i = 0; i < 7; ++i)
    ASSERT_EQ(sway.next({leap + (i % 2 ? restless : -restless), 0, 0}), Verdict::wild) << i;
  ASSERT_EQ(sway.next({leap + restless, 0, 0}), Verdict::stepped);
  const ImuStep& step = sway.gate.step();
  EXPECT_EQ(step.rate, Eigen::Vector3d(Eigen::Vector3d::Zero()));
  EXPECT_EQ(step.rate_sigma, 0);
  EXPECT_NEAR(step.turn_sigma, leap * 0.08 / 2, 0.1 * leap * 0.08 / 2);  // over .08 s
}

TEST(ImuGate, RefusesWhatNoVehicleCanDoHoweverLongItLasts) {
  Sway sway;
  sway.run(10);
  for (int i = 0; i < 300; ++i)  // nearly free fall
    EXPECT_EQ(sway.next({0, 0, 0}, {0, 0, 8}), Verdict::wild) << i;
}

TEST(ImuGate, FollowsAVehicleThatTurnsFasterAndFaster) {
  // 0.4 rad/s2 for 2 s, below the 0.5 rad/s2 that a vehicle can do.
  Sway sway;
  sway.run(10);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(sway.next({0, 0, 0.004 * i}), Verdict::good) << i;
}

TEST(ImuGate, KnowsAStepThatStaysAndSaysHowLargeItIs) {
  Sway sway;
  sway.run(10);
  int wild = 0;
  while (sway.next({5 * degree, 0, 0}) == Verdict::wild) ++wild;
  EXPECT_EQ(wild, 7) << "the eighth that agrees makes the step";
  const ImuStep& step = sway.gate.step();
  EXPECT_NEAR(step.rate.x(), 5 * degree, 5 * step.rate_sigma);
  EXPECT_EQ(step.rate.y(), 0);
  EXPECT_EQ(step.force.norm(), 0);
  EXPECT_GT(step.rate_sigma, 1.745e-3) << "the noise of one sample at least";
  EXPECT_LT(step.rate_sigma, 4e-3);
  EXPECT_FALSE(step.thawed);
  EXPECT_EQ(sway.run(60, {5 * degree, 0, 0}), 0) << "it is the sensor's new bias";
}

TEST(ImuGate, ASensorThatLeapsAndThenStandsStillIsNotUsedUntilItMoves) {
  Sway sway;
  sway.run(10);
  sway.next({5 * degree, 0, 0});
  sway.stuck = true;
  EXPECT_EQ(sway.run(30), 3000);
  sway.stuck = false;
  EXPECT_EQ(sway.next(), Verdict::good);
}

TEST(ImuGate, ASensorThatStoodStillAndMovesAgainHasNoNewBias) {
  Sway sway;
  sway.run(10);
  sway.stuck = true;
  sway.run(0.15);
  sway.stuck = false;
  int wild = 0;
  Verdict verdict = Verdict::wild;
  while ((verdict = sway.next({10 * degree, 0, 0})) == Verdict::wild) ++wild;
  EXPECT_EQ(verdict, Verdict::stepped);
  EXPECT_TRUE(sway.gate.step().thawed);
  EXPECT_EQ(sway.gate.step().rate.norm(), 0);
}

TEST(ImuGate, ANoisyImuWhoseSixValuesStandStillIsStuck) {
  // Twenty equal samples are taken for what they may be.
  Sway sway;
  sway.run(10);
  sway.stuck = true;
  EXPECT_NEAR(sway.run(10), 1000 - 20, 1);
  sway.stuck = false;
  EXPECT_EQ(sway.next(), Verdict::good);
}

TEST(ImuGate, AnImuWithoutNoiseMayStandStill) {
  ImuGate gate{VehicleLimits{}};
  for (int i = 0; i < 1000; ++i)
    EXPECT_EQ(gate.judge(test::imu(10L * i, std::min(0.001 * i, 0.2))), Verdict::good) << i;
}

TEST(ImuGate, WildChangesJustBelowTheLimitDoNotLiftItWithoutEnd) {
  // Each second sample is off by what passes at first; the mean counts at most twice its value.
  Sway sway;
  sway.run(10);
  int wild = 0;
  for (int i = 0; i < 2000; ++i)
    wild += sway.next({i % 5 == 0 ? 3 * degree : 0, 0, 0}) == Verdict::wild;
  EXPECT_EQ(wild, 400);
}

TEST(ImuGate, LearnsNoiseBeforeItJudges) {
  ImuGate gate{VehicleLimits{}};
  for (int i = 0; i < 50; ++i)
    EXPECT_EQ(gate.judge(test::imu(10L * i, i % 2 == 0 ? 0.5 : -0.5)), Verdict::good) << i;
}

}  // namespace
}  // namespace drydock::pipeline
