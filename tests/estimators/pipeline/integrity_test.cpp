// What estimates promise, and what becomes of it when a sensor is wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "estimators/frame/earth.hpp"
#include "estimators/pipeline/trust.hpp"
#include "tests/estimators/pipeline/resting_vehicle.hpp"
#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline {
namespace {

using test::at_ms;
using test::imu_device;
using test::log_device;
using namespace std::chrono_literals;

constexpr double one_degree = 0.0174533;

TEST(Bound, IsWhatANormalErrorExceedsOnceInTenMillionTimes) {
  // erfc(k / sqrt(2)) is the probability beyond k sigmas on both sides.
  EXPECT_NEAR(std::erfc(bound_sigmas / std::sqrt(2)), 1e-7, 1e-10);
  EXPECT_NEAR(bound_of(4, 0.5), 2 * bound_sigmas + 0.5, 1e-12);
}

TEST(Trust, IsBackFiveSecondsAfterTheLastContradiction) {
  Trust trust;
  EXPECT_TRUE(trust.settled(at_ms(0)));
  trust.judge(true, at_ms(0));
  trust.judge(true, at_ms(1500));
  EXPECT_EQ(trust.doubted(at_ms(1500)), 1500ms);
  trust.judge(false, at_ms(1600));
  EXPECT_EQ(trust.doubted(at_ms(1600)), 0ms);
  EXPECT_FALSE(trust.settled(at_ms(6500)));
  EXPECT_TRUE(trust.settled(at_ms(6501)));
}

/// A level vehicle at 2 m/s straight ahead to the north. IMU 100 Hz with noise of 1e-5 rad/s and
/// .005 m/s2, as the filters assume; log 2 Hz with .05 m/s.
class Ahead {
 public:
  explicit Ahead(EstimatorKind kind) {
    PipelineOptions options = test::moving(std::chrono::milliseconds{200});
    options.estimators[0].kind = std::move(kind);
    pipeline.emplace(*make_pipeline(options, estimates));
  }

  void run(double seconds) {
    for (long i = std::lround(100 * seconds); i > 0; --i) {
      if (tick % 50 == 0) {
        const double noise = 0.05 * normal_(random_);
        pipeline->receive(test::water_speed(10 * tick, 2 + noise + log_error));
      }
      auto imu = test::imu(10 * tick++);
      imu.angular_rate = frame::earth_rate_ned(0.6) + 1e-5 * noise() + rate_error;
      imu.specific_force = Eigen::Vector3d{0, 0, -9.8} + 0.005 * noise() + force_error;
      if (nan) imu.angular_rate.x() = std::nan("");
      if (spikes && tick % 7 == 0) imu.angular_rate.y() += 100 * one_degree;
      if (!silent) pipeline->receive(imu);
    }
  }
  bool valid() const { return pipeline->valid(0, at_ms(10 * tick)); }
  EstimatorStatus status() const { return pipeline->status(0); }
  double tilt() const {
    return std::hypot(estimates.all.back().roll_rad, estimates.all.back().pitch_rad);
  }

  test::Estimates estimates;
  std::optional<Pipeline> pipeline;
  std::int64_t tick = 0;
  Eigen::Vector3d rate_error = Eigen::Vector3d::Zero(), force_error = Eigen::Vector3d::Zero();
  double log_error = 0;
  bool spikes = false, silent = false, nan = false;

 private:
  Eigen::Vector3d noise() { return {normal_(random_), normal_(random_), normal_(random_)}; }

  std::mt19937_64 random_{8};
  std::normal_distribution<double> normal_;
};

EstimatorKind leveling_kind(leveling::FilterKind kind = leveling::FilterKind::augmented) {
  LevelingOptions options;
  options.log = log_device;
  options.kind = kind;
  options.filter = leveling::options_for(kind);
  options.filter.latitude_rad = 0.6;
  return options;
}

EstimatorKind mixing_kind() {
  MixingOptions options;
  options.log = log_device;
  options.filter.latitude_rad = 0.6;
  return options;
}

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

TEST(Pipeline, LeavesADeviceOutAndTakesItBack) {
  Ahead bench(leveling_kind());
  bench.run(60);
  bench.pipeline->leave_out(log_device, true, at_ms(60'000));
  EXPECT_TRUE(bench.pipeline->left_out(log_device));
  bench.log_error = 0.6;
  bench.run(30);
  EXPECT_TRUE(bench.valid()) << "without its log the attitude is known for minutes";
  EXPECT_EQ(bench.status().rejected, 0u);
  bench.log_error = 0;
  bench.pipeline->leave_out(log_device, false, at_ms(90'000));
  bench.run(10);
  bench.pipeline->flush();
  EXPECT_TRUE(bench.valid());
  const DeviceCounters& log = bench.pipeline->counters()[log_device];
  EXPECT_EQ(log.left_out, 60u);
  EXPECT_EQ(log.received,
            log.accepted + log.delayed + log.late + log.refused + log.unused + log.left_out);
}

TEST(Pipeline, AnEstimatorWithoutItsImuIsNotValid) {
  Ahead bench(leveling_kind());
  bench.run(60);
  bench.pipeline->leave_out(imu_device, true, at_ms(60'000));
  bench.run(1);
  EXPECT_FALSE(bench.valid());
  bench.pipeline->leave_out(imu_device, false, at_ms(61'000));
  bench.run(60);
  EXPECT_TRUE(bench.valid());
}

TEST(Navigation, OfSoundSensorsIsValidWithAPositionBound) {
  test::RestingVehicle bench(InertialMethod::sensors);
  bench.run(60);
  EXPECT_TRUE(bench.pipeline->status(0).valid);
  const auto& last = bench.last();
  const double variance = last.covariance(0, 0) + last.covariance(1, 1);
  EXPECT_DOUBLE_EQ(*last.integrity.horizontal_bound_m, bound_sigmas * std::sqrt(variance));
  EXPECT_LT(bench.offset().norm(), *last.integrity.horizontal_bound_m);
}

TEST(Navigation, WhoseDvlIsWrongIsNotValidUntilItIsRightAgain) {
  test::RestingVehicle bench(InertialMethod::sensors);
  bench.run(60);
  bench.dvl_error = {0.5, 0, 0};
  bench.run(8);
  EXPECT_FALSE(bench.pipeline->status(0).valid);
  bench.dvl_error.setZero();
  bench.run(40);
  EXPECT_TRUE(bench.pipeline->status(0).valid);
  EXPECT_LT(bench.last().velocity_ned.norm(), 0.05);
}

TEST(Navigation, ThatTwoSensorsContradictStartsAgainByItselfButNotForOneAlone) {
  for (const bool both : {true, false}) {
    test::RestingVehicle bench(InertialMethod::sensors);
    bench.run(60);
    bench.dvl_error = {2, 0, 0};
    if (both) bench.depth_error_m = 30;
    bench.run(30);
    EXPECT_EQ(bench.pipeline->status(0).divergences > 0, both);
    EXPECT_FALSE(bench.pipeline->status(0).valid);
    const Eigen::Vector3d velocity =
        bench.last().body_to_ned.conjugate() * bench.last().velocity_ned;
    EXPECT_NEAR(velocity.x(), both ? 2 : 0, 0.3);
  }
}

}  // namespace
}  // namespace drydock::pipeline
