#include "estimators/pipeline/leveling_estimator.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "estimators/frame/earth.hpp"
#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline {
namespace {

using test::at_ms;
using test::Estimates;
using test::imu;
using test::imu_device;
using test::leveling_of;
using test::log_device;
using test::water_speed;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

class LevelingEstimatorTest : public testing::Test {
 protected:
  LevelingEstimator make(bool stationary = false) {
    PipelineOptions options = test::moving(std::chrono::milliseconds{0});
    leveling_of(options).stationary = stationary;
    return {{7, imu_device}, leveling_of(options), options};
  }

  /// Feeds one second of samples from `ms` on, one every 10 ms.
  void feed(LevelingEstimator& estimator, int ms) {
    estimator.take(water_speed(ms), estimates_);
    for (int t = ms; t < ms + 1000; t += 10) estimator.take(imu(t), estimates_);
  }

  Estimates estimates_;
};

TEST_F(LevelingEstimatorTest, WaitsForTheImuThenForASpeedThenRuns) {
  LevelingEstimator estimator = make();
  EXPECT_EQ(estimator.status().state, EstimatorState::waiting_for_imu);
  EXPECT_EQ(estimator.take(imu(0), estimates_), Outcome::accepted);
  EXPECT_EQ(estimator.status().state, EstimatorState::waiting_for_speed);
  EXPECT_EQ(estimator.take(water_speed(5), estimates_), Outcome::accepted);
  EXPECT_TRUE(estimates_.all.empty());
  estimator.take(imu(10), estimates_);
  EXPECT_EQ(estimator.status().state, EstimatorState::running);
  ASSERT_EQ(estimates_.all.size(), 1u);
  EXPECT_EQ(estimates_.all[0].valid_at, at_ms(10));
  EXPECT_EQ(estimates_.all[0].estimator, 7);
  EXPECT_EQ(estimates_.all[0].fed_by, (1u << imu_device) | (1u << log_device));
  EXPECT_FALSE(estimates_.all[0].yaw_rad);
  EXPECT_GT(estimates_.all[0].covariance.determinant(), 0);
}

TEST_F(LevelingEstimatorTest, AStationaryOneNeedsNoSpeedAndUsesNone) {
  LevelingEstimator estimator = make(true);
  estimator.take(imu(0), estimates_);
  EXPECT_EQ(estimator.take(water_speed(5), estimates_), Outcome::unused);
  ASSERT_EQ(estimates_.all.size(), 1u);
  EXPECT_EQ(estimates_.all[0].fed_by, 1u << imu_device);
}

TEST_F(LevelingEstimatorTest, AStaleSpeedDoesNotStartIt) {
  LevelingEstimator estimator = make();
  estimator.take(water_speed(0), estimates_);
  estimator.take(imu(501), estimates_);
  EXPECT_EQ(estimator.status().state, EstimatorState::waiting_for_speed);
}

TEST_F(LevelingEstimatorTest, CountsTheInnovationsOfItsLog) {
  LevelingEstimator estimator = make();
  estimator.take(water_speed(0), estimates_);
  estimator.take(imu(0), estimates_);
  EXPECT_FALSE(estimator.status().taken.mean()) << "the speed that it starts with is no surprise";
  estimator.take(imu(10), estimates_);
  estimator.take(water_speed(10), estimates_);
  EXPECT_EQ(estimator.status().taken.count, 1u);
  const auto innovation =
      std::visit([](const auto& filter) { return filter.innovation(); }, estimator.filter());
  EXPECT_DOUBLE_EQ(*estimator.status().taken.mean(), innovation.log->normalised_square());
}

TEST_F(LevelingEstimatorTest, TellsTheInnovationsOfItsLogUsedOrNot) {
  LevelingEstimator estimator = make();
  for (int s = 0; s < 3; ++s) feed(estimator, 1000 * s);
  EXPECT_EQ(estimates_.innovations.size(), 2u) << "the speed that it starts with is no surprise";
  estimator.take(water_speed(3000, 90), estimates_);
  const auto& last = estimates_.innovations.back();
  EXPECT_EQ(last.valid_at, at_ms(3000));
  EXPECT_EQ(last.estimator, 7u);
  EXPECT_EQ(last.device, log_device);
  ASSERT_EQ(last.rows.size(), 1u);
  EXPECT_FALSE(last.rows[0].used);
  EXPECT_NEAR(last.rows[0].value, 88, 0.5);  // 90 m/s measured, 2 expected
  EXPECT_TRUE(estimates_.innovations[1].rows[0].used);
  EXPECT_LT(estimates_.innovations[1].rows[0].normalised_square(), 1);
}

TEST_F(LevelingEstimatorTest, ConstantTiltAtConstantSpeedComesOutAsTheTilt) {
  LevelingEstimator estimator = make();
  for (int t = 0; t < 30000; t += 10) {
    if (t % 500 == 0) estimator.take(water_speed(t), estimates_);
    estimator.take(imu(t), estimates_);
  }
  // f = -g alpha, up to the Coriolis acceleration (2 Omega V / g = 3e-5)
  EXPECT_NEAR(estimates_.all.back().roll_rad, std::atan2(0.1, 9.8), 1e-3);
  EXPECT_NEAR(estimates_.all.back().pitch_rad, std::atan2(0.2, std::hypot(0.1, 9.8)), 1e-3);
}

TEST_F(LevelingEstimatorTest, UsesOnlyItsOwnDevices) {
  LevelingEstimator estimator = make();
  EXPECT_EQ(estimator.take(imu(0, 0, log_device), estimates_), Outcome::unused);
  EXPECT_EQ(estimator.take(water_speed(0, 2, imu_device), estimates_), Outcome::unused);
}

TEST_F(LevelingEstimatorTest, ASpeedWithoutLongitudinalValueIsUnused) {
  LevelingEstimator estimator = make();
  auto speed = water_speed(0);
  speed.longitudinal_mps.reset();
  speed.transverse_mps = 0.5;
  EXPECT_EQ(estimator.take(speed, estimates_), Outcome::unused);
}

TEST_F(LevelingEstimatorTest, RefusesWhatIsNotFiniteOrAbsurdAndGoesOnAsIfItHadNotCome) {
  LevelingEstimator estimator = make(), undisturbed = make();
  Estimates expected;
  for (int t = 0; t < 1000; t += 10) {
    if (t % 500 == 0) {
      estimator.take(water_speed(t), estimates_);
      undisturbed.take(water_speed(t), expected);
    }
    for (const double bad : {nan, infinity, -infinity, 101.}) {
      auto sample = imu(t + 5);
      sample.specific_force.y() = bad;
      EXPECT_EQ(estimator.take(sample, estimates_), Outcome::refused);
      sample = imu(t + 5);
      sample.angular_rate.z() = bad;
      EXPECT_EQ(estimator.take(sample, estimates_), Outcome::refused);
      EXPECT_EQ(estimator.take(water_speed(t + 5, bad), estimates_), Outcome::refused);
    }
    estimator.take(imu(t), estimates_);
    undisturbed.take(imu(t), expected);
  }
  EXPECT_EQ(estimates_.all.back().roll_rad, expected.all.back().roll_rad);
  EXPECT_EQ(estimates_.all.back().covariance, expected.all.back().covariance);
}

TEST_F(LevelingEstimatorTest, AWrongSpeedIsOutsideTheGateCountedAndWithoutEffect) {
  for (const auto kind : {leveling::FilterKind::robust, leveling::FilterKind::augmented}) {
    PipelineOptions options = test::moving(std::chrono::milliseconds{0});
    leveling_of(options).kind = kind;
    leveling_of(options).filter = leveling::options_for(kind);
    const auto fly = [&](bool spoilt) {
      LevelingEstimator estimator({7, imu_device}, leveling_of(options), options);
      Estimates estimates;
      for (int t = 0; t <= 30000; t += 10) {
        const bool outlier = spoilt && t == 20000;
        if (t % 500 == 0) estimator.take(water_speed(t, outlier ? 9 : 2), estimates);
        estimator.take(imu(t), estimates);
      }
      EXPECT_EQ(estimator.status().rejected, spoilt ? 1u : 0u);
      return estimates.all.back();
    };
    const auto spoilt = fly(true), clean = fly(false);
    EXPECT_NEAR(spoilt.roll_rad, clean.roll_rad, 1e-4);
    EXPECT_NEAR(spoilt.pitch_rad, clean.pitch_rad, 1e-4);
  }
}

TEST_F(LevelingEstimatorTest, ASpeedThatStaysOutsideTheGateIsBelievedAfterAMinute) {
  LevelingEstimator estimator = make();
  const auto& filter = std::get<leveling::LevelingFilter>(estimator.filter());
  const auto run = [&](int from_ms, int to_ms, double mps) {
    for (int t = from_ms; t < to_ms; t += 10) {
      if (t % 500 == 0) estimator.take(water_speed(t, mps), estimates_);
      estimator.take(imu(t), estimates_);
    }
  };
  run(0, 20000, 2);
  // The fifth outlier, 2 s after the first, makes it a contradiction; it counts from then on.
  run(20000, 82000, 5);
  EXPECT_NEAR(filter.state()(0), 2, 0.1);
  EXPECT_FALSE(estimator.status().valid);
  EXPECT_EQ(estimator.status().rejected, 124u);
  run(82000, 120000, 5);
  EXPECT_NEAR(filter.state()(0), 5, 0.05);
  EXPECT_NEAR(estimates_.all.back().pitch_rad, std::atan2(0.2, 9.8), 0.01);
  EXPECT_TRUE(estimator.status().valid);
}

TEST_F(LevelingEstimatorTest, AGapStartsItAgainWithTheNextSpeed) {
  LevelingEstimator estimator = make();
  feed(estimator, 0);
  estimator.take(imu(990 + 501), estimates_);
  EXPECT_EQ(estimator.status().restarts, 1u);
  EXPECT_EQ(estimator.status().state, EstimatorState::waiting_for_speed);
  feed(estimator, 1500);
  EXPECT_EQ(estimator.status().state, EstimatorState::running);
  EXPECT_EQ(estimator.status().restarts, 1u);
  // An unknown acceleration of .3 m/s2 divided by gravity: 1.7 degrees.
  EXPECT_NEAR(std::sqrt(estimates_.all[100].covariance(0, 0)), 0.3 / 9.8, 1e-3);
  EXPECT_NEAR(std::sqrt(estimates_.all[100].covariance(1, 1)), 0.3 / 9.8, 1e-3);
}

TEST_F(LevelingEstimatorTest, NothingIsSaidWhileTheImuIsSilent) {
  LevelingEstimator estimator = make();
  feed(estimator, 0);
  for (int t = 1000; t < 31000; t += 500) estimator.take(water_speed(t), estimates_);
  EXPECT_EQ(estimates_.all.size(), 100u);
  feed(estimator, 31000);
  EXPECT_EQ(estimates_.all[100].valid_at, at_ms(31000));
  EXPECT_EQ(estimator.status().restarts, 1u);
}

TEST_F(LevelingEstimatorTest, AGapUpToTheLimitIsBridged) {
  LevelingEstimator estimator = make();
  feed(estimator, 0);
  estimator.take(imu(990 + 500), estimates_);
  EXPECT_EQ(estimator.status().restarts, 0u);
  EXPECT_EQ(estimates_.all.back().valid_at, at_ms(1490));
}

TEST_F(LevelingEstimatorTest, ABridgedGapCostsWhatTheLineMayBeWrongBy) {
  // T^3 / 12 times .5 rad/s3. The variance before the gap is small beside it.
  for (const auto kind : {leveling::FilterKind::robust, leveling::FilterKind::augmented}) {
    PipelineOptions options = test::moving(std::chrono::milliseconds{0});
    leveling_of(options).kind = kind;
    leveling_of(options).filter = leveling::options_for(kind);
    LevelingEstimator estimator({7, imu_device}, leveling_of(options), options);
    const auto turning_earth = [](int ms) {
      auto sample = imu(ms);
      sample.angular_rate = frame::earth_rate_ned(0.6);
      return sample;
    };
    for (int t = 0; t < 120000; t += 10) {
      if (t % 500 == 0) estimator.take(water_speed(t), estimates_);
      estimator.take(turning_earth(t), estimates_);
    }
    const double before = estimates_.all.back().covariance(0, 0);
    estimator.take(turning_earth(119990 + 500), estimates_);
    const double after = estimates_.all.back().covariance(0, 0);
    EXPECT_NEAR(std::sqrt(after - before), 0.5 * 0.125 / 12, 3e-4);
  }
}

TEST_F(LevelingEstimatorTest, AnOldOrRepeatedSampleIsLate) {
  LevelingEstimator estimator = make();
  feed(estimator, 0);
  EXPECT_EQ(estimator.take(imu(990), estimates_), Outcome::late);
  EXPECT_EQ(estimator.take(imu(985), estimates_), Outcome::late);
  EXPECT_EQ(estimates_.all.size(), 100u);
}

TEST_F(LevelingEstimatorTest, ASpeedBehindItsTimeIsUsedUntilTheLimit) {
  LevelingEstimator estimator = make();
  feed(estimator, 0);
  const auto& filter = std::get<leveling::LevelingFilter>(estimator.filter());
  const double before = filter.state()(0);
  EXPECT_EQ(estimator.take(water_speed(490, before + 1), estimates_), Outcome::delayed);
  EXPECT_GT(filter.state()(0), before);
  EXPECT_EQ(estimator.take(water_speed(489), estimates_), Outcome::late);
  EXPECT_EQ(estimator.take(water_speed(990), estimates_), Outcome::accepted);
  EXPECT_EQ(estimator.status().last_speed, at_ms(990));
}

TEST_F(LevelingEstimatorTest, SpeedsDoNotPullAtAStateWhoseImuIsSilent) {
  LevelingEstimator estimator = make();
  feed(estimator, 0);
  const auto& filter = std::get<leveling::LevelingFilter>(estimator.filter());
  const auto before = filter.state();
  EXPECT_EQ(estimator.take(water_speed(990 + 501, 9), estimates_), Outcome::unused);
  EXPECT_EQ(filter.state(), before);
}

TEST_F(LevelingEstimatorTest, AClockSetBackCostsTenSamplesAndARestart) {
  LevelingEstimator estimator = make();
  feed(estimator, 100000);
  int late = 0;
  for (int t = 0; t < 1000; t += 10) {
    if (t % 500 == 0) estimator.take(water_speed(t), estimates_);
    late += estimator.take(imu(t), estimates_) == Outcome::late;
  }
  EXPECT_EQ(late, 9);
  EXPECT_EQ(estimator.status().restarts, 1u);
  EXPECT_EQ(estimates_.all.back().valid_at, at_ms(990));
}

}  // namespace
}  // namespace drydock::pipeline
