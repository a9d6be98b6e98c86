// What estimates promise, and what becomes of it when a sensor is wrong.
#include <gtest/gtest.h>

#include <cmath>

#include "estimators/pipeline/trust.hpp"
#include "tests/estimators/pipeline/resting_vehicle.hpp"
#include "tests/estimators/pipeline/vehicle_ahead.hpp"

namespace drydock::pipeline {
namespace {

using test::Ahead;
using test::at_ms;
using test::imu_device;
using test::leveling_kind;
using test::log_device;
using namespace std::chrono_literals;

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
