// Faults that were there before the first sample came: nothing changes when they begin.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/estimators/consistency/faults_from.hpp"

namespace drydock::consistency::test {
namespace {

using namespace measurement;
using diagnosis::Sign;

/// That device is accused with that sign, and no other device.
void expect_only(std::uint16_t device, Sign sign, const Voyage& voyage) {
  const auto has_sign = [&](const auto& one) { return one.device == device && one.sign == sign; };
  EXPECT_TRUE(std::ranges::any_of(voyage.said(), has_sign));
  for (const auto& one : voyage.said())
    EXPECT_EQ(one.device, device) << to_string(one.sign) << " at " << one.at_s;
}

/// 50 kPa are 5 m of water, where no antenna has a fix.
TEST(FirstFault, ADepthThatPutsAnAntennaWithAFixUnderWaterIsOff) {
  Voyage voyage;
  voyage.run(60, from_the_start<DepthSample>([](auto& m) { *m.depth_m += 5; }));
  expect_only(depth, Sign::offset, voyage);
}

TEST(FirstFault, ADepthOfAVehicleThatLosesItsFixInADiveIsSound) {
  Voyage voyage;
  voyage.run(120, [](Measurement& measurement, double t) {
    if (auto* below = std::get_if<DepthSample>(&measurement); below && t > 60) *below->depth_m += 5;
    if (auto* bottom = std::get_if<BottomVelocity>(&measurement); bottom && t > 60)
      bottom->velocity.reset();
    if (auto* fix = std::get_if<GnssFix>(&measurement); fix && t > 65) {
      fix->position.reset();
      fix->velocity_ned.reset();
    }
  });
  for (const auto& one : voyage.said()) EXPECT_NE(one.sign, Sign::offset) << one.device;
}

TEST(FirstFault, ALogThatReadsOneMetreASecondTooMuchIsOffAndNoShaftIs) {
  Voyage voyage;
  voyage.run(300, from_the_start<WaterSpeed>([](auto& m) { *m.longitudinal_mps += 1; }));
  expect_only(log, Sign::offset, voyage);
}

TEST(FirstFault, ADvlThatReadsHalfAMetreASecondTooMuchIsOff) {
  Voyage voyage;
  voyage.run(100, from_the_start<BottomVelocity>([](auto& m) { m.velocity->x() += 0.5; }));
  expect_only(dvl, Sign::offset, voyage);
}

TEST(FirstFault, AReceiverThatReadsAThirdOfAMetreASecondTooLittleIsOff) {
  Voyage voyage;
  voyage.run(100, from_the_start<GnssFix>([](auto& m) { *m.velocity_ned *= 1 - 0.33 / 2; }));
  expect_only(gnss, Sign::offset, voyage);
}

/// No change shows it, and a value that never differed is no jump.
TEST(FirstFault, OfAUnitThatIsStuckFromItsFirstSampleOnIsCalledStuck) {
  Voyage voyage({dvl, gnss, imu, depth, compass});
  voyage.run(120, from_the_start<ImuSample>([](auto& m) {
               m.angular_rate = {1e-3, 2e-3, 3e-3};
               m.specific_force = {0.01, 0.02, -9.8};
             }));
  ASSERT_FALSE(voyage.said().empty());
  for (const auto& one : voyage.said()) {
    EXPECT_EQ(one.device, imu) << one.at_s;
    EXPECT_EQ(one.sign, Sign::stuck) << to_string(one.sign) << " at " << one.at_s;
  }
}

}  // namespace
}  // namespace drydock::consistency::test
