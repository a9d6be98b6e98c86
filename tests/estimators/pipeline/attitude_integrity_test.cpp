// What estimates of attitude promise, and what becomes of it when a sensor is wrong.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/estimators/pipeline/vehicle_ahead.hpp"

namespace drydock::pipeline {
namespace {

using test::Ahead;
using test::imu_device;
using test::leveling_kind;
using test::mixing_kind;
using test::one_degree;

class EveryAttitude : public testing::TestWithParam<int> {
 protected:
  static EstimatorKind kind() {
    switch (GetParam()) {
      case 0: return leveling_kind();
      case 1: return leveling_kind(leveling::FilterKind::robust);
      default: return mixing_kind();
    }
  }
};

std::string kind_name(const testing::TestParamInfo<int>& info) {
  constexpr std::array names{"augmented", "robust", "mixing"};
  return names.at(static_cast<std::size_t>(info.param));
}

INSTANTIATE_TEST_SUITE_P(Estimators, EveryAttitude, testing::Values(0, 1, 2), kind_name);

TEST_P(EveryAttitude, OfSoundSensorsStaysValidAndWithinItsBounds) {
  Ahead bench(kind());
  bench.run(600);
  ASSERT_TRUE(bench.valid());
  EXPECT_EQ(bench.status().wild + bench.status().steps + bench.status().divergences, 0u);
  EXPECT_GT(static_cast<double>(bench.status().valid_estimates),
            0.98 * static_cast<double>(bench.status().estimates));
  for (const auto& estimate : bench.estimates.all) {
    if (!estimate.integrity.valid) continue;
    EXPECT_LE(std::abs(estimate.roll_rad), estimate.integrity.roll_bound_rad);
    EXPECT_LE(std::abs(estimate.pitch_rad), estimate.integrity.pitch_bound_rad);
  }
}

TEST_P(EveryAttitude, IsNotMovedBySpikesOfAGyro) {
  Ahead bench(kind());
  bench.run(60);
  bench.spikes = true;
  bench.run(60);
  bench.pipeline->flush();
  EXPECT_EQ(bench.status().wild, 857u);  // each seventh of 6000 samples
  EXPECT_EQ(bench.pipeline->counters()[imu_device].refused, 857u);
  EXPECT_TRUE(bench.valid());
  EXPECT_LT(bench.tilt(), 0.1 * one_degree);
}

TEST(MixingIntegrity, AGyroThatDriftsMakesItInvalidBeforeItIsFiveSigmasWrongForTwoSeconds) {
  for (const double drift_degps2 : {0.025, 0.05, 0.15}) {
    Ahead bench(mixing_kind());
    bench.run(120);
    ASSERT_TRUE(bench.valid());
    double wrong_s = 0, longest_s = 0;
    for (int i = 0; i < 200; ++i) {
      bench.rate_error.x() += 0.1 * drift_degps2 * one_degree;
      bench.run(0.1);
      const auto& now = bench.estimates.all.back();
      const bool wrong =
          now.integrity.valid && std::abs(now.roll_rad) > 5 * std::sqrt(now.covariance(0, 0));
      wrong_s = wrong ? wrong_s + 0.1 : 0;
      longest_s = std::max(longest_s, wrong_s);
    }
    EXPECT_LT(longest_s, 2) << drift_degps2;
    EXPECT_FALSE(bench.valid()) << drift_degps2;
  }
}

TEST_P(EveryAttitude, TakesAStepOfAGyroAsItsBiasAndIsValidAgain) {
  Ahead bench(kind());
  bench.run(60);
  bench.rate_error = {3 * one_degree, 0, 0};
  bench.run(3);
  EXPECT_FALSE(bench.valid()) << "no vehicle does so";
  EXPECT_EQ(bench.status().steps, 1u);
  bench.run(30);
  EXPECT_TRUE(bench.valid());
  EXPECT_LT(bench.tilt(), 1 * one_degree);
  EXPECT_LT(std::abs(bench.estimates.all.back().roll_rad),
            bench.estimates.all.back().integrity.roll_bound_rad);
}

TEST_P(EveryAttitude, IsNotValidWhileItsImuIsSilentOrGivesNoNumbers) {
  for (const bool nan : {false, true}) {
    Ahead bench(kind());
    bench.run(60);
    ASSERT_TRUE(bench.valid());
    (nan ? bench.nan : bench.silent) = true;
    bench.run(0.4);
    EXPECT_TRUE(bench.valid()) << "a gap that is bridged";
    bench.run(0.6);
    EXPECT_FALSE(bench.valid());
    bench.nan = bench.silent = false;
    bench.run(60);
    EXPECT_TRUE(bench.valid());
    EXPECT_EQ(bench.status().restarts, 1u);
  }
}

// A bias of 1 deg/s for 30 s tilts a loop by up to 30 degrees, and the loop keeps what a
// manoeuvre could have caused. Given the first attitude, it is not that of the new start.
TEST(Mixing, BeginsAnewWhenAFindingAboutItsImuIsOver) {
  for (const bool given : {false, true}) {
    auto kind = mixing_kind();
    std::get<MixingOptions>(kind).filter.accelerometer_start = !given;
    std::get<MixingOptions>(kind).filter.initial_roll_rad = given ? 20 * one_degree : 0;
    Ahead bench(kind);
    bench.run(60);
    for (int i = 0; i <= 100; ++i) {  // it creeps in, so that no sample is wild
      bench.rate_error.x() = 0.01 * one_degree * i;
      bench.run(0.1);
    }
    bench.pipeline->doubt(imu_device, true);
    bench.run(20);
    for (int i = 100; i >= 0; --i) {
      bench.rate_error.x() = 0.01 * one_degree * i;
      bench.run(0.1);
    }
    EXPECT_GT(bench.tilt(), 3 * one_degree);
    bench.pipeline->doubt(imu_device, false);
    for (int i = 0; i < 300; ++i) {
      bench.run(0.1);
      const auto& last = bench.estimates.all.back();
      if (!last.integrity.valid) continue;
      ASSERT_LT(std::abs(last.roll_rad), 5 * std::sqrt(last.covariance(0, 0))) << i;
    }
    EXPECT_TRUE(bench.valid());
    EXPECT_LT(bench.tilt(), 0.5 * one_degree);
    EXPECT_EQ(bench.status().restarts, 1u);
  }
}

// A bias of 1 mg tilts a filter of six states by 0.0573 degrees, whatever its innovations say.
TEST(Leveling, OfSixStatesCountsTheBiasOfItsAccelerometersInItsCovariance) {
  Ahead bench(leveling_kind());
  bench.run(600);
  const auto& last = bench.estimates.all.back();
  EXPECT_GT(std::sqrt(last.covariance(0, 0)), 0.0573 * one_degree);
  EXPECT_GT(std::sqrt(last.covariance(1, 1)), 0.0573 * one_degree);
  EXPECT_NEAR(last.integrity.roll_bound_rad, bound_sigmas * std::sqrt(last.covariance(0, 0)),
              1e-12);
}

TEST(Leveling, WhoseGyroDriftsIsNotValidAndStartsAgainByItself) {
  // The drift ends at 1 deg/s, a hundred times beyond what the filter knows of its gyro.
  Ahead bench(leveling_kind());
  bench.run(60);
  for (int i = 0; i < 200; ++i) {
    bench.rate_error.x() = 0.005 * one_degree * i;
    bench.run(0.1);
  }
  EXPECT_GE(bench.status().divergences, 1u);
  bench.run(60);
  EXPECT_TRUE(bench.valid());
  EXPECT_LT(std::abs(bench.estimates.all.back().roll_rad),
            bench.estimates.all.back().integrity.roll_bound_rad);
}

TEST(Leveling, WhoseLogIsWrongGoesOnWithoutIt) {
  Ahead bench(leveling_kind()), sound(leveling_kind());
  bench.run(60);
  sound.run(60);
  bench.log_error = 0.6;
  bench.run(10);
  EXPECT_FALSE(bench.valid());
  bench.run(20);
  sound.run(30);
  EXPECT_NEAR(bench.tilt(), sound.tilt(), 0.05 * one_degree);
  bench.log_error = 0;
  bench.run(20);
  EXPECT_TRUE(bench.valid());
  EXPECT_EQ(bench.status().divergences, 0u);
}

TEST(Leveling, WhoseLogDriftsDoubtsWhatItDidBeforeItContradicted) {
  Ahead bench(leveling_kind()), sound(leveling_kind());
  bench.run(60);
  sound.run(60);
  for (int i = 0; i < 300 && bench.valid(); ++i) {
    bench.log_error += 0.05 * 0.1;
    bench.run(0.1);
    sound.run(0.1);
  }
  EXPECT_FALSE(bench.valid());
  const auto &wrong = bench.estimates.all.back(), &right = sound.estimates.all.back();
  ASSERT_EQ(wrong.valid_at, right.valid_at);
  // The pitch went with the log's acceleration. Its variance is more by about the square of that.
  const double moved = std::abs(wrong.pitch_rad - right.pitch_rad);
  const double more = wrong.covariance(1, 1) - right.covariance(1, 1);
  EXPECT_GT(moved, 0.003 * one_degree);
  EXPECT_GT(more, 0.5 * moved * moved);
  EXPECT_LT(more, 4 * moved * moved);
}

}  // namespace
}  // namespace drydock::pipeline
