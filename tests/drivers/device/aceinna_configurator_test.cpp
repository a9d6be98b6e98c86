#include <gtest/gtest.h>

#include "tests/drivers/device/support.hpp"

/// Frames follow the vendor's DBC: settings 18FF55 to 18FF58, BIT and status 18FF52 to 18FF54.
namespace drydock::device::test {
namespace aceinna_configurator_test {

constexpr std::uint32_t accs_id = 0x08F02D80;
const auto accs = can_frame(accs_id, true, {0x31, 0x79, 0x55, 0x7D, 0x0A, 0x7D, 0x80, 0x06});
constexpr unsigned own = 247;

struct Bus {
  explicit Bus(const DriverOptions& o) : driver(frame_driver(o)) { driver->restart(at_s(0), ear); }
  void says(const wire::CanFrame& frame, double at) {
    run(at);
    driver->receive(frame, at_s(at), ear);
  }
  void run(double end) {
    for (auto due = driver->deadline(); due && *due <= at_s(end); due = driver->deadline()) {
      driver->tick(*due, ear);
    }
  }
  std::size_t sent(const wire::CanFrame& frame) const {
    return static_cast<std::size_t>(std::ranges::count(ear.sent_frames, frame));
  }

  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

DriverOptions at_50_hz() {
  auto o = options(Kind::imu, "aceinna");
  o.aceinna.rate_divider = std::uint8_t{2};
  return o;
}

const auto set_50_hz = can_frame(0x18FF5500 | own, true, {0x80, 2});
const auto ask_names = can_frame(0x18EAFFFE, true, {0x00, 0xEE, 0x00});
const auto ask_rate = can_frame(0x18EA8000 | own, true, {0x55, 0xFF, 0x00});
const auto ask_hardware = can_frame(0x18EA8000 | own, true, {0x52, 0xFF, 0x00});
const auto ask_status = can_frame(0x18EA8000 | own, true, {0x54, 0xFF, 0x00});

TEST(AceinnaConfigurator, WithoutSettingsOnlyTheNamesOnTheBusAreAskedFor) {
  Bus bus(options(Kind::imu, "aceinna"));
  bus.says(accs, 1);
  bus.run(10);
  ASSERT_EQ(bus.ear.sent_frames.size(), 1U);
  EXPECT_EQ(bus.ear.sent_frames[0], ask_names);
}

TEST(AceinnaConfigurator, ClaimsAnAddressThenSetsAndAsks) {
  Bus bus(at_50_hz());
  ASSERT_EQ(bus.ear.sent_frames.size(), 2U);
  EXPECT_EQ(bus.ear.sent_frames[0], ask_names);
  EXPECT_EQ(bus.ear.sent_frames[1].id, 0x18EEFF00u | own);
  bus.says(accs, 0.1);  // the device is heard
  bus.run(0.2);
  EXPECT_EQ(bus.ear.sent_frames.size(), 2U);  // J1939-81: the address is valid after 250 ms
  bus.run(0.3);
  ASSERT_EQ(bus.ear.sent_frames.size(), 4U);
  EXPECT_EQ(bus.ear.sent_frames[2], set_50_hz);
  EXPECT_EQ(bus.ear.sent_frames[3], ask_rate);
}

TEST(AceinnaConfigurator, AConfirmedSettingIsLeftAndBitAndStatusAskedInTurn) {
  Bus bus(at_50_hz());
  bus.says(accs, 0.1);
  bus.says(can_frame(0x18FF5580, true, {0x80, 2}), 0.31);
  bus.run(2.5);
  EXPECT_EQ(bus.sent(set_50_hz), 1U);
  EXPECT_EQ(bus.sent(ask_hardware), 2U);
  EXPECT_EQ(bus.sent(ask_status), 1U);
  EXPECT_TRUE(bus.ear.reports.empty());
}

TEST(AceinnaConfigurator, ADeviceThatDoesNotAnswerIsReportedAfterThreeTries) {
  Bus bus(at_50_hz());
  bus.says(accs, 0.1);
  bus.run(2);
  EXPECT_EQ(bus.sent(set_50_hz), 3U);
  EXPECT_EQ(bus.ear.reports,
            std::vector<std::string>{"the IMU does not say its packet rate after it was set"});
}

TEST(AceinnaConfigurator, ADeviceThatKeepsItsOwnIsReported) {
  Bus bus(at_50_hz());
  bus.says(accs, 0.1);
  for (const double at : {0.31, 0.51, 0.71}) bus.says(can_frame(0x18FF5580, true, {0x80, 1}), at);
  bus.run(2);
  EXPECT_EQ(bus.ear.reports,
            std::vector<std::string>{"the IMU keeps another packet rate than was set"});
}

TEST(AceinnaConfigurator, SetsAllFourInTurn) {
  auto o = at_50_hz();
  o.aceinna.packets = std::uint8_t{6};
  o.aceinna.filter = AceinnaSettings::Filter{25, 5};
  o.aceinna.orientation = std::uint16_t{0x0009};
  Bus bus(o);
  bus.says(accs, 0.1);
  bus.says(can_frame(0x18FF5580, true, {0x80, 2}), 0.31);
  bus.says(can_frame(0x18FF5680, true, {0x80, 6}), 0.33);
  bus.says(can_frame(0x18FF5780, true, {0x80, 25, 5}), 0.35);
  bus.says(can_frame(0x18FF5880, true, {0x80, 0x09, 0x00}), 0.37);
  bus.run(0.4);
  EXPECT_EQ(bus.sent(can_frame(0x18FF5600 | own, true, {0x80, 6})), 1U);
  EXPECT_EQ(bus.sent(can_frame(0x18FF5700 | own, true, {0x80, 25, 5})), 1U);
  EXPECT_EQ(bus.sent(can_frame(0x18FF5800 | own, true, {0x80, 0x09, 0x00})), 1U);
  EXPECT_TRUE(bus.ear.reports.empty());
}

TEST(AceinnaConfigurator, ADeviceThatBootsAgainIsSetAgain) {
  Bus bus(at_50_hz());
  bus.says(accs, 0.1);
  bus.says(can_frame(0x18FF5580, true, {0x80, 2}), 0.31);
  bus.says(can_frame(0x18EEFF80, true, {1, 0, 0, 0, 0x37, 3, 0, 0x80}), 5);
  bus.run(5.1);
  EXPECT_EQ(bus.sent(set_50_hz), 2U);
}

TEST(AceinnaImuDriver, WhatBitAndStatusComplainOfIsReportedOnce) {
  Bus bus(options(Kind::imu, "aceinna"));
  bus.says(accs, 1);
  const auto gyro_error = can_frame(0x18FF5280, true, {0x04, 0x00});
  bus.says(gyro_error, 1.1);
  bus.says(gyro_error, 1.2);
  bus.says(can_frame(0x18FF5380, true, {0x00, 0x04, 0x00, 0x04, 0xAA, 0xAA, 0xAA, 0xAA}), 1.3);
  bus.says(can_frame(0x18FF5281, true, {0x08, 0x00}), 1.4);  // from another device
  EXPECT_EQ(bus.ear.reports, std::vector<std::string>{"the IMU reports: internal gyro error"});
}

}  // namespace aceinna_configurator_test
}  // namespace drydock::device::test
