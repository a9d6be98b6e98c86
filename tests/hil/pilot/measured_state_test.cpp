#include "hil/pilot/measured_state.hpp"

#include <gtest/gtest.h>

#include "estimators/frame/attitude.hpp"
#include "hil/pilot/pilot.hpp"

namespace drydock::pilot {
namespace {

using measurement::Origin;
using rig_config::DeviceKind;

Stamp at_s(double t) { return Stamp{measurement::from_seconds(t)}; }

rig_config::DeviceConfig sensor(const char* name, DeviceKind kind, std::array<double, 3> arm = {}) {
  rig_config::DeviceConfig config;
  config.name = name;
  config.kind = kind;
  config.lever_arm_m = arm;
  return config;
}

rig_config::Rig sensors() {
  rig_config::Rig rig;
  rig.devices = {sensor("imu", DeviceKind::imu), sensor("compass", DeviceKind::attitude),
                 sensor("depth", DeviceKind::depth, {2, 0, 0.5}),
                 sensor("log", DeviceKind::emlog, {0, 0.4, 0})};
  return rig;
}

Origin from(std::uint16_t device, double t) {
  Origin origin;
  origin.valid_at = at_s(t);
  origin.device = device;
  return origin;
}

void hear_all(MeasuredState& state, double t) {
  state.receive(measurement::ImuSample{from(0, t), {0, 0, 0}, {0, 0, 0.1}});
  measurement::AttitudeSample attitude;
  attitude.origin = from(1, t);
  attitude.roll_rad = 0;
  attitude.pitch_rad = 0.1;
  attitude.true_heading_rad = 1;
  state.receive(attitude);
  measurement::DepthSample depth;
  depth.origin = from(2, t);
  depth.depth_m = 10;
  state.receive(depth);
  measurement::WaterSpeed speed;
  speed.origin = from(3, t);
  speed.longitudinal_mps = 2;
  state.receive(speed);
}

// The depth sensor is 2 m ahead and 0.5 m below; at a pitch of 0.1 rad its bow stands higher by 2
// sin 0.1, its foot lower by 0.5 cos 0.1. The log, 0.4 m to starboard, moves back by 0.04 m/s in
// the turn.
TEST(MeasuredState, LeverArmsAreTakenOff) {
  MeasuredState state(sensors());
  hear_all(state, 1);
  const auto now = state.at(at_s(1.5));
  ASSERT_TRUE(now);
  EXPECT_NEAR(-now->height_m, 10 + 2 * std::sin(0.1) - 0.5 * std::cos(0.1), 1e-12);
  EXPECT_NEAR(now->velocity[0], 2 + 0.04, 1e-12);
  EXPECT_NEAR(frame::euler(now->body_to_ned).yaw, 1, 1e-12);
  EXPECT_EQ(now->velocity[5], 0.1);
}

TEST(MeasuredState, AValueOlderThanASecondIsMissing) {
  MeasuredState state(sensors());
  EXPECT_EQ(state.missing(at_s(0)), "heading");
  hear_all(state, 1);
  EXPECT_TRUE(state.at(at_s(2)));
  EXPECT_FALSE(state.at(at_s(2.001)));
  measurement::AttitudeSample heading_alone;
  heading_alone.origin = from(1, 2);
  heading_alone.heading_rad = 1;
  state.receive(heading_alone);
  EXPECT_EQ(state.missing(at_s(2.1)), "roll and pitch");
}

TEST(MeasuredState, OtherSensorsOfAKindDoNotSteer) {
  MeasuredState state(sensors());
  hear_all(state, 1);
  measurement::DepthSample other;
  other.origin = from(7, 1.5);
  other.depth_m = 99;
  state.receive(other);
  EXPECT_LT(-state.at(at_s(1.6))->height_m, 20);
}

TEST(MeasuredState, ARigWithoutASensorIsRefusedByItsName) {
  auto rig = sensors();
  rig.devices.erase(rig.devices.begin() + 2);
  try {
    const MeasuredState state(rig);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(
        error.what(),
        "an autopilot that steers over the wires sails by devices of kind attitude, depth, "
        "emlog and imu; there is none of kind depth");
  }
}

TEST(Pilot, ARigWhereNothingTakesOrdersIsRefused) {
  const auto nowhere = [](const std::string&, const wire::CanFrame&) {};
  try {
    const OrderPorts ports(sensors(), nowhere, [](const std::string&) {});
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "nothing takes the orders of the mission's autopilot; allowed: devices of kind "
                 "actuator with nmea2000 or cia402");
  }
}

}  // namespace
}  // namespace drydock::pilot
