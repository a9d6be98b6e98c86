#include "tests/drivers/device/support.hpp"

/// CiA 404 pressure transmitters. The frames are written by hand from the makers' manuals.
namespace drydock::device::test {
namespace pressure_driver_test {

using measurement::DepthSample;
using wire::cia404_pressure::find_unit;
using wire::cia404_pressure::Form;

struct Bus {
  explicit Bus(const DriverOptions& o) : driver(frame_driver(o)) { driver->restart(at_s(0), ear); }
  void says(std::uint32_t id, std::initializer_list<unsigned> data, double at = 1) {
    driver->receive(can_frame(id, false, data), at_s(at), ear);
  }
  DepthSample only() const {
    const auto all = ear.all<DepthSample>();
    EXPECT_EQ(all.size(), 1U);
    return all.empty() ? DepthSample{} : all.front();
  }
  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

DriverOptions transmitter(const char* unit, unsigned decimals,
                          Form form = Form::integer_and_status) {
  DriverOptions o = options(Kind::depth, "cia404-pressure");
  o.pressure.scale = {form, *find_unit(unit), decimals};
  return o;
}

TEST(PressureDriver, TheExampleOfDanfossInBarIsTenMetresOfWater) {
  Bus bus(transmitter("bar", 5));  // 100000 means 1 bar
  bus.says(0x181, {0xA0, 0x86, 0x01, 0x00, 0x00});
  EXPECT_NEAR(bus.only().pressure_pa.value(), 1e5, 1e-9);
  EXPECT_NEAR(bus.only().depth_m.value(), (1e5 - 101'325) / (1025 * 9.80665), 1e-12);
}

TEST(PressureDriver, AGaugeCountsFromTheSurface) {
  DriverOptions o = transmitter("Pa", 0);
  o.pressure.gauge = true;
  o.water.surface_pressure_pa = 100'850;
  Bus bus(o);
  bus.says(0x181, {0xA0, 0x86, 0x01, 0x00, 0x00});
  EXPECT_NEAR(bus.only().pressure_pa.value(), 200'850, 1e-9);
  EXPECT_NEAR(bus.only().depth_m.value(), 1e5 / (1025 * 9.80665), 1e-9);
}

TEST(PressureDriver, RealNumbersAsConfigured) {
  Bus bus(transmitter("bar", 0, Form::real32));
  bus.says(0x181, {0x00, 0x00, 0x24, 0x41});  // 10.25
  EXPECT_NEAR(bus.only().pressure_pa.value(), 10.25e5, 1e-6);
}

TEST(PressureDriver, AStatusThatIsNotZeroLeavesTheSampleEmpty) {
  Bus bus(transmitter("Pa", 0));
  bus.says(0x181, {0xA0, 0x86, 0x01, 0x00, 0x01});
  EXPECT_FALSE(bus.only().pressure_pa);
  EXPECT_FALSE(bus.only().depth_m);
}

TEST(PressureDriver, APressureBelowZeroIsRefusedAsOnEveryOtherBus) {
  Bus bus(transmitter("Pa", 0));
  bus.says(0x181, {0x00, 0x00, 0x00, 0x80, 0x00});  // -2147483648
  EXPECT_TRUE(bus.ear.heard.empty());
  ASSERT_EQ(bus.ear.refusals.size(), 1U);
  EXPECT_EQ(bus.ear.refusals[0],
            "a pressure below zero or over 1200 bar was refused: damaged, or in another unit");
}

TEST(PressureDriver, AnotherUnitThanConfiguredShowsAsAPressureOfNoSea) {
  Bus bus(transmitter("bar", 0));
  bus.says(0x181, {0xA0, 0x86, 0x01, 0x00, 0x00});  // 100000 Pa, read as bar
  EXPECT_TRUE(bus.ear.heard.empty());
  EXPECT_EQ(bus.ear.refusals.size(), 1U);
}

TEST(PressureDriver, AGaugeSlightlyBelowZeroAtTheSurfaceIsADepthAboveIt) {
  DriverOptions o = transmitter("Pa", 0);
  o.pressure.gauge = true;
  Bus bus(o);
  bus.says(0x181, {0x0C, 0xFE, 0xFF, 0xFF, 0x00});  // -500 Pa
  EXPECT_NEAR(bus.only().depth_m.value(), -500 / (1025 * 9.80665), 1e-9);
}

TEST(PressureDriver, StartsItsNodeWhenTheBusOpensAndAtEachBootUp) {
  DriverOptions o = transmitter("Pa", 0);
  o.address = 5;
  Bus bus(o);
  bus.says(0x705, {0x00});
  ASSERT_EQ(bus.ear.sent_frames.size(), 2U);
  for (const auto& sent : bus.ear.sent_frames) {
    EXPECT_EQ(sent.id, 0U);
    EXPECT_EQ(sent.data[0], 1);
    EXPECT_EQ(sent.data[1], 5);
  }
  bus.says(0x181, {0xA0, 0x86, 0x01, 0x00, 0x00});  // another node
  EXPECT_TRUE(bus.ear.heard.empty());
}

TEST(PressureDriver, TellsOfEmergencies) {
  Bus bus(transmitter("Pa", 0));
  bus.says(0x081, {0x00, 0x10, 0x81, 0, 0, 0, 0, 0});
  EXPECT_EQ(bus.ear.reports.size(), 1U);
}

}  // namespace pressure_driver_test
}  // namespace drydock::device::test
