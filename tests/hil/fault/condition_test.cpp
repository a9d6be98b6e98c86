// The internal effects of faults on a device. Without a fault it is sound.
#include "hil/fault/schedule/condition.hpp"

#include <gtest/gtest.h>

#include "tests/hil/fault/faults.hpp"

namespace drydock::fault::test {
namespace condition_test {

using rig_config::DeviceKind;

TEST(FaultCondition, WithoutFaultsADeviceIsSound) {
  const auto is = condition_under({}, DeviceKind::dvl);
  EXPECT_TRUE(is.primary.none());
  EXPECT_TRUE(is.secondary.none());
  EXPECT_EQ(is.primary.noise_times, 1);
  EXPECT_EQ(is.clock.shows(start), start);
  EXPECT_EQ(is.times_fewer, 1);
  EXPECT_FALSE(is.stuck_at);
  EXPECT_TRUE(is.troubles.empty());
}

TEST(FaultCondition, ABiasIsOnTheQuantityThatItsKeyNames) {
  FaultConfig rate = fault_of(FaultKind::bias, 2), force = fault_of(FaultKind::bias, 3);
  rate.quantity = "rate_degps";
  force.quantity = "specific_force_mps2";
  const std::vector<FaultConfig> of_imu{rate, force};
  const auto imu = condition_under(in_force(of_imu), DeviceKind::imu);
  EXPECT_EQ(imu.primary.bias.x(), 2);
  EXPECT_EQ(imu.secondary.bias.x(), 3);

  // Velocity is the first quantity of a DVL, but the second of a GNSS receiver, after the position.
  FaultConfig velocity = fault_of(FaultKind::bias, 5);
  velocity.quantity = "velocity_mps";
  const std::vector<FaultConfig> faults{velocity};
  EXPECT_EQ(condition_under(in_force(faults), DeviceKind::dvl).primary.bias.x(), 5);
  EXPECT_EQ(condition_under(in_force(faults), DeviceKind::gnss).secondary.bias.x(), 5);
}

TEST(FaultCondition, OfTwoOfAKindTheLaterOneHolds) {
  const std::vector<FaultConfig> faults{fault_of(FaultKind::bias, 2), fault_of(FaultKind::bias, 5)};
  EXPECT_EQ(condition_under(in_force(faults), DeviceKind::imu).primary.bias.x(), 5);
}

TEST(FaultCondition, ADeviceAsksForAFaultThatItAloneKnows) {
  const std::vector<FaultConfig> faults{fault_of(FaultKind::hot, 20), fault_of(FaultKind::hot, 5)};
  const auto is = condition_under(in_force(faults), DeviceKind::dvl);
  ASSERT_TRUE(is.under(FaultKind::hot));
  EXPECT_EQ(is.under(FaultKind::hot)->amount, 5) << "the later one holds";
  EXPECT_EQ(is.under(FaultKind::hot)->since, start);
  EXPECT_FALSE(is.under(FaultKind::nak));
}

TEST(FaultCondition, ADriftingClockIsOffByItsRateTimesTheTimeSinceThen) {
  const std::vector<FaultConfig> faults{fault_of(FaultKind::clock_drift, 50)};
  const auto clock = condition_under(in_force(faults), DeviceKind::imu).clock;
  EXPECT_EQ(clock.shows(start), start);
  // 50 ppm of 1000 s are 50 ms.
  EXPECT_EQ(clock.shows(start + 1000s), start + 1000s + 50ms);
}

TEST(FaultCondition, AClockThatWasSetWrongShowsSoMuchMoreOrLess) {
  const std::vector<FaultConfig> faults{fault_of(FaultKind::clock_step, -3600)};
  EXPECT_EQ(condition_under(in_force(faults), DeviceKind::imu).clock.shows(start), start - 1h);
}

TEST(FaultCondition, WhatTheWireDoesIsNoMatterOfTheDevice) {
  const std::vector<FaultConfig> faults{fault_of(FaultKind::drop, 1), fault_of(FaultKind::delay, 1),
                                        fault_of(FaultKind::unplug)};
  const auto is = condition_under(in_force(faults), DeviceKind::imu);
  EXPECT_TRUE(is.primary.none());
  EXPECT_TRUE(is.secondary.none());
}

}  // namespace condition_test
}  // namespace drydock::fault::test
