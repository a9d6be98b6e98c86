#include <gtest/gtest.h>

#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace cia402_driver_test {

using measurement::ActuatorState;

DriverOptions drive(std::uint8_t actuator) {
  auto o = options(Kind::actuator, "cia402");
  o.address = 11;
  o.instance = actuator;
  return o;
}

/// What the driver of node 11 publishes for a TPDO1: status word, then INTEGER32.
struct Heard {
  explicit Heard(std::uint8_t actuator) : driver(frame_driver(drive(actuator))) {}
  void status(std::uint16_t word, std::array<std::uint8_t, 4> actual, std::uint32_t id = 0x18B) {
    const auto low = static_cast<std::uint8_t>(word), high = static_cast<std::uint8_t>(word >> 8);
    driver->receive(can_frame(id, false, {low, high, actual[0], actual[1], actual[2], actual[3]}),
                    at_s(1), ear);
  }
  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

// 65536 increments are a turn: 1820 (71Ch) are 9.9976 degrees.
TEST(Cia402Driver, TheInstanceSaysWhichActuatorItReports) {
  const double turn = 2 * std::numbers::pi;
  for (const std::uint8_t actuator : {0, 1, 2, 3, 4, 9}) {  // from 4 on a thruster
    Heard heard(actuator);
    heard.status(0x0237, {0x1C, 0x07, 0, 0});
    const auto states = heard.ear.all<ActuatorState>();
    ASSERT_EQ(states.size(), 1);
    const std::array values{states[0].rudder_rad, states[0].stern_plane_rad,
                            states[0].bow_plane_rad, states[0].propeller_radps};
    const std::size_t told = std::min<std::size_t>(actuator, 3);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i].has_value(), i == told);
    EXPECT_DOUBLE_EQ(values.at(told).value(), 1820 * turn / 65536);
  }
}

TEST(Cia402Driver, ASurfaceBeyondNinetyDegreesIsRefusedAShaftIsNot) {
  Heard plane(1), shaft(3);
  for (Heard* each : {&plane, &shaft}) each->status(0x0237, {0, 0, 0x0A, 0});  // ten turns
  EXPECT_TRUE(plane.ear.heard.empty());
  EXPECT_EQ(plane.ear.refusals.size(), 1);
  EXPECT_NEAR(shaft.ear.all<ActuatorState>().at(0).propeller_radps.value(), 20 * std::numbers::pi,
              1e-9);
}

TEST(Cia402Driver, AFaultIsSaidOnceAndTheValueIsPublishedAllTheSame) {
  Heard heard(0);
  heard.status(0x0218, {0, 0, 0, 0});
  heard.status(0x0218, {0, 0, 0, 0});
  EXPECT_EQ(heard.ear.reports, std::vector<std::string>{"the drive is in fault"});
  EXPECT_EQ(heard.ear.heard.size(), 2);
}

TEST(Cia402Driver, OrdersAndOtherDrivesAreNoReports) {
  Heard heard(0);
  heard.status(0x000F, {0x1C, 0x07, 0, 0}, 0x20B);
  heard.status(0x0237, {0x1C, 0x07, 0, 0}, 0x18C);
  EXPECT_TRUE(heard.ear.heard.empty());
}

TEST(ActuatorDriver, AnOrderOfWhoeverSteersIsNoReportAndNoSource) {
  auto driver = frame_driver(options(Kind::actuator, "nmea2000"));
  Ear ear;
  const auto rudder = [&](std::uint32_t source, std::initializer_list<unsigned> data) {
    driver->receive(can_frame(0x09F10D00 | source, true, data), at_s(1), ear);
  };
  rudder(0x20, {0, 0xF8, 0xD1, 0x06, 0xFF, 0x7F, 0xFF, 0xFF});
  EXPECT_TRUE(ear.heard.empty());
  rudder(0x24, {0, 0xF8, 0xFF, 0x7F, 0xD1, 0x06, 0xFF, 0xFF});
  EXPECT_NEAR(ear.all<ActuatorState>().at(0).rudder_rad.value(), -0.1745, 1e-12);
}

}  // namespace cia402_driver_test
}  // namespace drydock::device::test
