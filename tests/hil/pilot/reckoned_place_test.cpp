#include "hil/pilot/reckoned_place.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "estimators/frame/attitude.hpp"

namespace drydock::pilot {
namespace reckoned_place_test {

using rig_config::DeviceKind;

constexpr double latitude = std::numbers::pi / 5;

Stamp at_s(double t) { return Stamp{measurement::from_seconds(t)}; }

rig_config::Rig rig() {
  rig_config::Rig rig;
  rig.mission.latitude_rad = latitude;
  rig.devices.resize(2);
  rig.devices[0].kind = DeviceKind::dvl;
  rig.devices[0].lever_arm_m = {2, 0, 0};
  rig.devices[1].kind = DeviceKind::gnss;
  rig.devices[1].lever_arm_m = {3, 0, 0};
  return rig;
}

/// Heading east at 1.5 m/s through the water.
motion::VehicleState eastward() {
  motion::VehicleState state;
  state.body_to_ned = frame::body_to_ned({0, 0, std::numbers::pi / 2});
  state.velocity[0] = 1.5;
  return state;
}

/// Metres north and east of where the mission begins, after `seconds` of steps of 50 ms.
Eigen::Vector2d after(ReckonedPlace& place, motion::VehicleState& state, double from_s,
                      double to_s) {
  for (int i = 1; i <= std::lround((to_s - from_s) / 0.05); ++i)
    place.place(state, at_s(from_s + 0.05 * i));
  return frame::ned_offset({latitude, 0, 0}, {state.latitude_rad, state.longitude_rad, 0})
      .head<2>();
}

void hear_dvl(ReckonedPlace& place, double t, Eigen::Vector3d velocity, std::uint16_t device = 0) {
  measurement::BottomVelocity dvl;
  dvl.origin.device = device;
  dvl.origin.valid_at = at_s(t);
  dvl.velocity = velocity;
  place.receive(dvl);
}

TEST(ReckonedPlace, WithoutADvlTheWayThroughTheWaterCounts) {
  ReckonedPlace place(rig(), at_s(0));
  auto state = eastward();
  const auto offset = after(place, state, 0, 20);
  EXPECT_NEAR(offset.x(), 0, 1e-3);
  EXPECT_NEAR(offset.y(), 30, 1e-3);
}

// The DVL, 2 m ahead, is moved to starboard by 0.2 m/s in a turn of 0.1 rad/s.
TEST(ReckonedPlace, AFreshDvlCountsInsteadAndItsLeverArmIsTakenOff) {
  ReckonedPlace place(rig(), at_s(0));
  auto state = eastward();
  state.velocity[5] = 0.1;
  hear_dvl(place, 0.5, {1, 0.5, 0});
  hear_dvl(place, 0.5, {9, 9, 9}, 1);  // of another device
  auto offset = after(place, state, 0, 1.5);
  EXPECT_NEAR(offset.x(), -0.3 * 1.5, 1e-6);
  EXPECT_NEAR(offset.y(), 1.5, 1e-6);
  offset = after(place, state, 1.5, 2.5);
  EXPECT_NEAR(offset.y(), 1.5 + 1.5, 1e-6) << "a second later the DVL is old";
}

// A fix of the antenna, 3 m ahead on a course east, is 3 m too far to the east.
TEST(ReckonedPlace, AFixReplacesTheSum) {
  ReckonedPlace place(rig(), at_s(0));
  auto state = eastward();
  after(place, state, 0, 20);
  measurement::GnssFix fix;
  fix.origin.device = 1;
  const auto there = frame::at_ned_offset({latitude, 0, 0}, {7, 100, 0});
  fix.position = measurement::Geodetic{there.latitude_rad, there.longitude_rad};
  place.receive(fix);
  const auto offset = after(place, state, 20, 20.05);
  EXPECT_NEAR(offset.x(), 7, 1e-3);
  EXPECT_NEAR(offset.y(), 97, 1e-3);
}

TEST(ReckonedPlace, AGapAddsASecondAtMost) {
  ReckonedPlace place(rig(), at_s(0));
  auto state = eastward();
  place.place(state, at_s(60));
  EXPECT_NEAR(after(place, state, 60, 60).y(), 1.5, 1e-6);
}

}  // namespace reckoned_place_test
}  // namespace drydock::pilot
