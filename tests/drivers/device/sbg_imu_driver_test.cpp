#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace sbg_imu_driver_test {

using measurement::ImuSample;

// By SBG's table: 0.25, -1, -9.81 m/s2; 0.1, -0.001, 2 rad/s.
const auto acceleration = can_frame(0x121, false, {0x19, 0x00, 0x9C, 0xFF, 0x2B, 0xFC});
const auto rate = can_frame(0x122, false, {0x64, 0x00, 0xFF, 0xFF, 0xD0, 0x07});

wire::CanFrame time_of_group(std::uint32_t us) {
  const auto byte = [&](unsigned i) { return static_cast<std::uint8_t>(us >> 8 * i); };
  return can_frame(0x120, false, {byte(0), byte(1), byte(2), byte(3), 0, 0, 0, 0});
}

struct SbgBus {
  SbgBus() : driver(frame_driver(options(Kind::imu, "sbg"))) {}
  void says(const wire::CanFrame& frame, double at) { driver->receive(frame, at_s(at), ear); }
  std::vector<ImuSample> samples() const { return ear.all<ImuSample>(); }

  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

TEST(SbgImuDriver, JoinsTheTwoVectorsOfAGroup) {
  SbgBus bus;
  bus.says(time_of_group(1'000'000), 5);
  bus.says(acceleration, 5.0003);
  bus.says(rate, 5.0006);
  ASSERT_EQ(bus.samples().size(), 1U);
  const ImuSample s = bus.samples()[0];
  EXPECT_NEAR(s.specific_force.x(), 0.25, 1e-9);
  EXPECT_NEAR(s.specific_force.y(), -1, 1e-9);
  EXPECT_NEAR(s.specific_force.z(), -9.81, 1e-9);
  EXPECT_NEAR(s.angular_rate.x(), 0.1, 1e-9);
  EXPECT_NEAR(s.angular_rate.z(), 2, 1e-9);
  EXPECT_EQ(s.origin.device_time, std::chrono::seconds{1});
  EXPECT_EQ(s.origin.received_at, at_s(5.0006));
  EXPECT_LT(s.origin.valid_at, at_s(5));
}

TEST(SbgImuDriver, ALateGroupHasTheTimeOfTheDevicesClock) {
  SbgBus bus;
  const auto group = [&](std::uint32_t us, double at) {
    bus.says(time_of_group(us), at);
    bus.says(acceleration, at + 0.0003);
    bus.says(rate, at + 0.0006);
  };
  group(1'000'000, 5);
  group(1'010'000, 5.013);  // 3 ms late
  ASSERT_EQ(bus.samples().size(), 2U);
  const auto apart = bus.samples()[1].origin.valid_at - bus.samples()[0].origin.valid_at;
  EXPECT_LT(std::chrono::abs(apart - std::chrono::milliseconds{10}), std::chrono::microseconds{2});
}

TEST(SbgImuDriver, TheClockWrapsAfter71Minutes) {
  SbgBus bus;
  bus.says(time_of_group(0xFFFFFFFF - 4999), 5);
  bus.says(acceleration, 5.0003);
  bus.says(rate, 5.0006);
  bus.says(time_of_group(5000), 5.01);
  bus.says(acceleration, 5.0103);
  bus.says(rate, 5.0106);
  ASSERT_EQ(bus.samples().size(), 2U);
  const auto apart = bus.samples()[1].origin.valid_at - bus.samples()[0].origin.valid_at;
  // The two times have other stuff bits: up to 24 bits of 4 us.
  EXPECT_LT(std::chrono::abs(apart - std::chrono::milliseconds{10}), std::chrono::microseconds{96});
}

TEST(SbgImuDriver, HalvesOfTwoGroupsAreNotJoined) {
  SbgBus bus;
  bus.says(time_of_group(1'000'000), 5);
  bus.says(acceleration, 5.0003);  // its rate was lost
  bus.says(time_of_group(1'001'000), 5.001);
  bus.says(rate, 5.0016);
  EXPECT_TRUE(bus.samples().empty());
}

/// A busy host reads the rate 25 ms late, and what waited behind it together with it.
TEST(SbgImuDriver, HalvesThatWereReadFarApartAreASampleIfTheDevicesTimeGoesOn) {
  SbgBus bus;
  const auto group = [&](std::uint32_t us, double at, double rate_at) {
    bus.says(time_of_group(us), at);
    bus.says(acceleration, at + 0.0003);
    bus.says(rate, rate_at);
  };
  group(1'000'000, 5, 5.0006);
  group(1'010'000, 5.01, 5.0106);
  group(1'020'000, 5.02, 5.0456);
  EXPECT_EQ(bus.samples().size(), 2U) << "the third waits for the time of the fourth";
  group(1'030'000, 5.0457, 5.0459);
  ASSERT_EQ(bus.samples().size(), 4U);
  EXPECT_EQ(bus.samples()[2].origin.device_time, std::chrono::milliseconds{1020});
  EXPECT_EQ(bus.samples()[2].origin.received_at, at_s(5.0456));
}

TEST(SbgImuDriver, HalvesFarApartAreNoneIfATimeIsMissing) {
  SbgBus bus;
  for (const std::uint32_t i : {0U, 1U, 2U}) {
    bus.says(time_of_group(1'000'000 + 10'000 * i), 5 + 0.01 * i);
    bus.says(acceleration, 5.0003 + 0.01 * i);
    if (i < 2) bus.says(rate, 5.0006 + 0.01 * i);
  }
  bus.says(rate, 5.0306);  // of the fourth, whose time and acceleration were lost
  bus.says(time_of_group(1'040'000), 5.04);
  EXPECT_EQ(bus.samples().size(), 2U);
}

TEST(SbgImuDriver, WithoutTheTimeOfItsGroupASampleHasTheTimeOfItsFrames) {
  SbgBus bus;
  bus.says(acceleration, 5);
  bus.says(rate, 5.0003);
  ASSERT_EQ(bus.samples().size(), 1U);
  EXPECT_FALSE(bus.samples()[0].origin.device_time);
  EXPECT_LT(at_s(5) - bus.samples()[0].origin.valid_at, std::chrono::milliseconds{1});
}

}  // namespace sbg_imu_driver_test
}  // namespace drydock::device::test
