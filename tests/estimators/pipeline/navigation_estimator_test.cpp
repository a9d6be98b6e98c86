#include <gtest/gtest.h>

#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/frame/local_earth.hpp"
#include "tests/estimators/pipeline/resting_vehicle.hpp"

namespace drydock::pipeline {
namespace {

using test::RestingVehicle;

class EveryInertialMethod : public testing::TestWithParam<InertialMethod> {};

std::string method_name(const testing::TestParamInfo<InertialMethod>& info) {
  constexpr std::array names{"sensors", "coupled", "paper"};
  return names.at(static_cast<std::size_t>(info.param));
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryInertialMethod,
                         testing::Values(InertialMethod::sensors, InertialMethod::coupled,
                                         InertialMethod::paper),
                         method_name);

TEST_P(EveryInertialMethod, StaysWhereTheVehicleRests) {
  RestingVehicle bench(GetParam());
  bench.run(60);
  ASSERT_EQ(bench.pipeline->status(0).state, EstimatorState::running);
  EXPECT_LT(bench.offset().norm(), 0.05);
  EXPECT_LT(bench.last().velocity_ned.norm(), 0.002);
  EXPECT_LT(bench.last().body_to_ned.angularDistance(bench.attitude()), 1e-5);
  EXPECT_EQ(bench.pipeline->status(0).rejected, 0u);
  EXPECT_EQ(bench.listener.all.size(), 599u);  // one every 0.1 s; the last step is not complete
}

TEST_P(EveryInertialMethod, RefusesOutliersCountsThemAndStaysRight) {
  RestingVehicle bench(GetParam());
  bench.run(30);
  bench.dvl_error = {3, 0, 0};
  bench.depth_error_m = 50;
  bench.log_error_mps = GetParam() == InertialMethod::sensors ? 0 : 2;
  bench.run(1);
  bench.dvl_error.setZero();
  bench.depth_error_m = bench.log_error_mps = 0;
  bench.run(10);
  const std::uint64_t depths = 10, speeds = GetParam() == InertialMethod::sensors ? 0 : 2;
  EXPECT_EQ(bench.pipeline->status(0).rejected, 1 + depths + speeds);
  EXPECT_LT(bench.offset().norm(), 0.1);
  EXPECT_LT(bench.last().velocity_ned.norm(), 0.01);
}

TEST_P(EveryInertialMethod, TellsWhatEachMeasurementHadOfTheUnexpected) {
  RestingVehicle bench(
      GetParam(), [](auto&) {}, std::chrono::milliseconds{0});
  bench.run(30);
  bench.dvl_error = {3, 0, 0};
  bench.depth_error_m = 50;
  bench.run(1);
  const auto& dvl = bench.listener.innovations[6];
  EXPECT_EQ(dvl.reports, 31u);
  EXPECT_EQ(dvl.used, 3 * 31u - 1);
  EXPECT_EQ(dvl.refused, 1u);
  EXPECT_EQ(dvl.last.valid_at, test::at_ms(30'000));
  EXPECT_NEAR(dvl.last.rows[0].value, 3, 0.01);  // measured minus expected, forward
  EXPECT_FALSE(dvl.last.rows[0].used);
  EXPECT_GT(dvl.last.rows[0].sigma,
            bench.options.ground_sigma_mps);  // plus the uncertainty of the state
  EXPECT_LT(dvl.last.rows[0].sigma, 2 * bench.options.ground_sigma_mps);
  EXPECT_LT(dvl.squares, 20);  // sensors without noise
  const auto& depth = bench.listener.innovations[7];
  EXPECT_EQ(depth.reports, 310u);
  EXPECT_EQ(depth.refused, 10u);
  EXPECT_NEAR(depth.last.rows[0].value, 50, 0.1);  // deeper than expected
  EXPECT_EQ(bench.listener.innovations[test::log_device].used,
            GetParam() == InertialMethod::sensors ? 0u : 62u);
  std::uint64_t refused = 0;
  for (const auto& of : bench.listener.innovations) refused += of.refused;
  EXPECT_EQ(refused, bench.pipeline->status(0).rejected);
}

TEST_P(EveryInertialMethod, IsMovedByTheSameOutliersWithoutItsGate) {
  RestingVehicle bench(GetParam(), [](InertialOptions& o) { o.navigation.gate_sigma = 0; });
  bench.run(30);
  bench.dvl_error = {3, 0, 0};
  bench.depth_error_m = 50;
  bench.run(1);
  EXPECT_EQ(bench.pipeline->status(0).rejected, 0u);
  EXPECT_GT(std::hypot(bench.last().velocity_ned.norm(), bench.offset().norm()), 0.05);
}

TEST_P(EveryInertialMethod, BridgesAShortSilenceAndKnowsThatItIsLessCertain) {
  RestingVehicle whole(GetParam()), gap(GetParam());
  whole.run(20.9);
  gap.run(20);
  gap.skip(0.4);
  gap.run(0.5);
  ASSERT_EQ(gap.pipeline->status(0).state, EstimatorState::running);
  EXPECT_LT(gap.offset().norm(), 0.05);
  EXPECT_GT(gap.last().covariance(6, 6), 10 * whole.last().covariance(6, 6));
}

TEST_P(EveryInertialMethod, IsLostAfterALongOneAndSaysNothingMore) {
  RestingVehicle bench(GetParam());
  bench.run(20);
  const auto before = bench.listener.all.size();
  const auto at = bench.now;
  bench.skip(0.6);
  bench.run(5);
  EXPECT_EQ(bench.pipeline->status(0).state, EstimatorState::lost);
  EXPECT_EQ(*bench.pipeline->status(0).lost_at, at - std::chrono::milliseconds{10});
  EXPECT_LE(bench.listener.all.size(), before + 1);
}

TEST_P(EveryInertialMethod, TakesLeversOutOfATurningVehiclesSensors) {
  // The vehicle turns about its origin. A sensor one or two metres away moves, although the origin
  // does not.
  RestingVehicle bench(GetParam(), [](InertialOptions& o) {
    o.imu_lever = {1, 0.5, -0.3};
    o.ground->lever = {-2, 0.4, 0.5};
    o.depth->lever = {-1, 0, 0.7};
    if (o.log) o.log->lever = {1.5, -0.5, 0};
  });
  bench.turn_radps = 0.05;
  if (GetParam() == InertialMethod::paper)
    bench.turn_radps = 0;  // its simulator cannot turn like this
  bench.run(60);
  EXPECT_EQ(bench.pipeline->status(0).rejected, 0u);
  EXPECT_LT(bench.offset().norm(), 0.05);
  EXPECT_LT(bench.last().velocity_ned.norm(), 0.005);
}

TEST(NavigationEstimator, TakesPositionsAndSaysWhoFedIt) {
  RestingVehicle bench(InertialMethod::sensors);
  bench.run(10);
  EXPECT_EQ(bench.last().fed_by, (1u << 3) | (1u << 6) | (1u << 7));
  measurement::GnssFix fix;
  fix.origin.device = 9;
  fix.origin.valid_at = bench.now - std::chrono::milliseconds{10};
  const auto there = frame::at_ned_offset(bench.position(), {4, -3, 0});
  fix.position = measurement::Geodetic{there.latitude_rad, there.longitude_rad};
  fix.horizontal_accuracy_m = 0.01;
  bench.pipeline->receive(fix);
  bench.run(1);
  EXPECT_NEAR(bench.offset().x(), 4, 0.05);
  EXPECT_NEAR(bench.offset().y(), -3, 0.05);
  EXPECT_TRUE((bench.last().fed_by >> 9) & 1u);
  EXPECT_LT(std::sqrt(bench.last().covariance(0, 0)), 0.02);
}

TEST(NavigationEstimator, FindsMeasurementsThatComeTooLate) {
  RestingVehicle bench(InertialMethod::coupled);
  bench.run(10);
  auto log = test::water_speed(0, 0, 5);
  log.origin.valid_at = bench.now - std::chrono::seconds{2};
  bench.pipeline->receive(log);
  bench.run(1);
  EXPECT_EQ(bench.pipeline->counters()[5].late, 1u);
}

TEST(NavigationEstimate, EulerCovarianceIsThatOfSmallRotations) {
  NavigationEstimate estimate;
  const frame::Euler angles{0.4, -0.7, 2.1};
  estimate.body_to_ned = frame::body_to_ned(angles);
  const Eigen::Vector3d turn{3e-7, -2e-7, 5e-7};
  estimate.covariance.bottomRightCorner<3, 3>() = turn * turn.transpose();
  const Eigen::Quaterniond turned =
      Eigen::Quaterniond{Eigen::AngleAxisd{turn.norm(), turn.normalized()}} * estimate.body_to_ned;
  const auto after = frame::euler(turned);
  const Eigen::Vector3d by{after.roll - angles.roll, after.pitch - angles.pitch,
                           after.yaw - angles.yaw};
  EXPECT_LT((euler_covariance(estimate) - by * by.transpose()).norm(), 1e-18);
}

}  // namespace
}  // namespace drydock::pipeline
