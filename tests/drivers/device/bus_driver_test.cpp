#include "tests/drivers/device/support.hpp"

/// Depth and actuators. The frames are written by hand from the field tables of canboat's public
/// PGN database.
namespace drydock::device::test {
namespace bus_driver_test {

using measurement::ActuatorState;
using measurement::DepthSample;

struct Bus {
  explicit Bus(const DriverOptions& o) : driver(frame_driver(o)) {}
  void says(std::uint32_t id, std::initializer_list<unsigned> data, double at = 1) {
    driver->receive(can_frame(id, true, data), at_s(at), ear);
  }
  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

constexpr std::uint32_t pressure_id = 0x15FD0A23, temperature_id = 0x15FD0823;
constexpr std::uint32_t rudder_id = 0x09F10D11, engine_id = 0x09F20011;

// 201325.0 Pa = 2013250 tenths = 0x001EB842.
constexpr std::initializer_list<unsigned> water_pressure{0, 0, 1, 0x42, 0xB8, 0x1E, 0x00, 0xFF};

TEST(DepthDriver, DepthIsPressureOverDensityAndStandardGravity) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(pressure_id, water_pressure);
  const auto all = bus.ear.all<DepthSample>();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(all[0].pressure_pa.value(), 201325, 1e-6);
  EXPECT_NEAR(all[0].depth_m.value(), 100000 / (1025 * 9.80665), 1e-9);
  EXPECT_FALSE(all[0].temperature_k);
}

TEST(DepthDriver, SurfacePressureAndDensityAreConfiguration) {
  DriverOptions o = options(Kind::depth, "nmea2000");
  o.water.surface_pressure_pa = 201325 - 1000 * 9.80665;
  o.water.density_kgm3 = 1000;
  Bus bus(o);
  bus.says(pressure_id, water_pressure);
  EXPECT_NEAR(bus.ear.all<DepthSample>().at(0).depth_m.value(), 1, 1e-9);
}

TEST(DepthDriver, StandardOceanWaterAtTheConfiguredLatitude) {
  DriverOptions o = options(Kind::depth, "nmea2000");
  o.water.unesco_latitude_rad = 30 * degree;
  Bus bus(o);
  // 100101325.0 Pa: the sea pressure of 10000 dbar, the report's check value.
  bus.says(pressure_id, {0, 0, 1, 0x02, 0x40, 0xAA, 0x3B, 0xFF});
  EXPECT_NEAR(bus.ear.all<DepthSample>().at(0).depth_m.value(), 9712.653, 5e-4);
}

TEST(DepthDriver, OtherPressuresAreNoDepth) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(pressure_id, {0, 0, 0, 0x42, 0xB8, 0x1E, 0x00, 0xFF});  // atmospheric
  bus.says(pressure_id, {0, 0, 4, 0x42, 0xB8, 0x1E, 0x00, 0xFF});  // hydraulic
  EXPECT_TRUE(bus.ear.heard.empty());
}

TEST(DepthDriver, APressureBelowZeroIsDamagedAndNoDepth) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(pressure_id, {0, 0, 1, 0x42, 0xB8, 0x1E, 0x80, 0xFF});  // its highest bit is flipped
  EXPECT_TRUE(bus.ear.heard.empty());
  ASSERT_EQ(bus.ear.refusals.size(), 1U);
  EXPECT_EQ(bus.ear.refusals[0],
            "a pressure below zero or over 1200 bar was refused: damaged, or in another unit");
}

TEST(DepthDriver, NotAvailableNeverBecomesADepth) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(pressure_id, {0, 0, 1, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF});
  bus.says(pressure_id, {0, 0, 1, 0xFE, 0xFF, 0xFF, 0x7F, 0xFF});
  for (const auto& sample : bus.ear.all<DepthSample>()) {
    EXPECT_FALSE(sample.pressure_pa);
    EXPECT_FALSE(sample.depth_m);
  }
}

TEST(DepthDriver, SeaTemperatureComesWithTheNextPressure) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(temperature_id, {0, 0, 0, 0x4B, 0x6F, 0xFF, 0xFF, 0xFF}, 1);  // 28491 -> 284.91 K
  bus.says(pressure_id, water_pressure, 2);
  bus.says(pressure_id, water_pressure, 20);  // too old now
  const auto all = bus.ear.all<DepthSample>();
  EXPECT_NEAR(all.at(0).temperature_k.value(), 284.91, 1e-9);
  EXPECT_FALSE(all.at(1).temperature_k);
}

TEST(DepthDriver, EchoSounderGivesTheAltitude) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(0x0DF50B74, {0x00, 0xD0, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF});  // recorded: 2.08 m
  const auto all = bus.ear.all<DepthSample>();
  EXPECT_NEAR(all.at(0).altitude_m.value(), 2.08, 1e-9);
  EXPECT_FALSE(all.at(0).depth_m);
}

TEST(DepthDriver, TwoPressureSensorsAreNotMixedUntilOneFallsSilent) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(pressure_id, water_pressure, 1);
  bus.says(pressure_id + 1, water_pressure, 1.5);
  EXPECT_EQ(bus.ear.heard.size(), 1U);
  bus.says(pressure_id + 1, water_pressure, 11.5);
  EXPECT_EQ(bus.ear.heard.size(), 2U);
}

TEST(ActuatorDriver, ASurfaceBeyondNinetyDegreesIsDamagedAndNoAngle) {
  Bus bus(options(Kind::actuator, "nmea2000"));
  bus.says(rudder_id, {0, 0xF8, 0xFF, 0x7F, 0x00, 0x40, 0xFF, 0xFF});  // 1.6384 rad
  EXPECT_TRUE(bus.ear.heard.empty());
  ASSERT_EQ(bus.ear.refusals.size(), 1U);
  EXPECT_EQ(bus.ear.refusals[0], "a surface beyond 90 degrees was dropped: damaged on its way");
}

TEST(ActuatorDriver, StarboardRudderOfTheBusIsNegativeHere) {
  Bus bus(options(Kind::actuator, "nmea2000"));
  bus.says(rudder_id, {0x00, 0xF8, 0xFF, 0x7F, 0xD0, 0x07, 0xFF, 0xFF});  // 2000 -> 0.2 rad
  const auto all = bus.ear.all<ActuatorState>();
  EXPECT_NEAR(all.at(0).rudder_rad.value(), -0.2, 1e-12);
  EXPECT_FALSE(all.at(0).stern_plane_rad);
}

TEST(ActuatorDriver, InstancesOneAndTwoAreThePlanes) {
  Bus bus(options(Kind::actuator, "nmea2000"));
  bus.says(rudder_id, {0x01, 0xF8, 0xFF, 0x7F, 0xD0, 0x07, 0xFF, 0xFF});
  bus.says(rudder_id, {0x02, 0xF8, 0xFF, 0x7F, 0x30, 0xF8, 0xFF, 0xFF});  // -2000
  bus.says(rudder_id, {0x03, 0xF8, 0xFF, 0x7F, 0x30, 0xF8, 0xFF, 0xFF});  // belongs to no actuator
  const auto all = bus.ear.all<ActuatorState>();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0].stern_plane_rad.value(), 0.2, 1e-12);
  EXPECT_NEAR(all[1].bow_plane_rad.value(), -0.2, 1e-12);
}

TEST(ActuatorDriver, ShaftSpeedInRadiansPerSecond) {
  Bus bus(options(Kind::actuator, "nmea2000"));
  bus.says(engine_id, {0x00, 0x60, 0x09, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF});  // 2400 / 4 = 600 rpm
  bus.says(engine_id, {0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF});
  const auto all = bus.ear.all<ActuatorState>();
  EXPECT_NEAR(all.at(0).propeller_radps.value(), 20 * std::numbers::pi, 1e-9);
  EXPECT_FALSE(all.at(1).propeller_radps);
}

TEST(ActuatorDriver, OfTwoEnginesTheFirstHeardIsKeptAndTheOtherIsCounted) {
  Bus bus(options(Kind::actuator, "nmea2000"));
  for (int i = 0; i < 3; ++i) {
    bus.says(engine_id, {0x01, 0x60, 0x09, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF});  // 600 rpm
    bus.says(engine_id, {0x00, 0x40, 0x06, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF});  // 400 rpm
  }
  const auto all = bus.ear.all<ActuatorState>();
  ASSERT_EQ(all.size(), 3U);
  for (const auto& state : all)
    EXPECT_NEAR(state.propeller_radps.value(), 20 * std::numbers::pi, 1e-9);
  ASSERT_EQ(bus.ear.refusals.size(), 3U);
  EXPECT_EQ(bus.ear.refusals[0],
            "engine instance 0 was left out: instance 1 came first; the key instance chooses");
}

TEST(ActuatorDriver, TheConfiguredEngineIsTheOnlyOneAndTheOtherIsNoTrouble) {
  DriverOptions o = options(Kind::actuator, "nmea2000");
  o.instance = 1;
  Bus bus(o);
  bus.says(engine_id, {0x00, 0x40, 0x06, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF});  // 400 rpm
  bus.says(engine_id, {0x01, 0x60, 0x09, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF});  // 600 rpm
  const auto all = bus.ear.all<ActuatorState>();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(all[0].propeller_radps.value(), 20 * std::numbers::pi, 1e-9);
  EXPECT_TRUE(bus.ear.refusals.empty());
}

TEST(ActuatorDriver, AnEngineThatFellSilentGivesItsPlaceToAnother) {
  Bus bus(options(Kind::actuator, "nmea2000"));
  bus.says(engine_id, {0x01, 0x60, 0x09, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF}, 1);
  bus.says(engine_id, {0x00, 0x40, 0x06, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF}, 11.5);
  EXPECT_EQ(bus.ear.all<ActuatorState>().size(), 2U);
}

TEST(ActuatorDriver, ARudderInstanceOfNoActuatorIsCounted) {
  Bus bus(options(Kind::actuator, "nmea2000"));
  bus.says(rudder_id, {0x03, 0xF8, 0xFF, 0x7F, 0x30, 0xF8, 0xFF, 0xFF});
  EXPECT_TRUE(bus.ear.heard.empty());
  EXPECT_EQ(bus.ear.refusals.size(), 1U);
}

TEST(DepthDriver, TwoPressuresOfOneSenderDoNotAlternate) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(pressure_id, water_pressure);
  bus.says(pressure_id, {0, 1, 1, 0x42, 0xB8, 0x0E, 0x00, 0xFF});  // instance 1
  EXPECT_EQ(bus.ear.all<DepthSample>().size(), 1U);
  ASSERT_EQ(bus.ear.refusals.size(), 1U);
  EXPECT_EQ(bus.ear.refusals[0],
            "pressure instance 1 was left out: instance 0 came first; the key instance chooses");
}

TEST(DepthDriver, TheConfiguredPressureInstanceIsTaken) {
  DriverOptions o = options(Kind::depth, "nmea2000");
  o.instance = 1;
  Bus bus(o);
  bus.says(pressure_id, water_pressure);
  bus.says(pressure_id, {0, 1, 1, 0x42, 0xB8, 0x1E, 0x00, 0xFF});
  EXPECT_EQ(bus.ear.all<DepthSample>().size(), 1U);
}

TEST(DepthDriver, TwoSeaTemperaturesOfOneSenderDoNotAlternate) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(temperature_id, {0, 0, 0, 0x4B, 0x6F, 0xFF, 0xFF, 0xFF}, 1);  // 284.91 K
  bus.says(temperature_id, {0, 1, 0, 0x4B, 0x70, 0xFF, 0xFF, 0xFF}, 1);
  bus.says(pressure_id, water_pressure, 2);
  EXPECT_NEAR(bus.ear.all<DepthSample>().at(0).temperature_k.value(), 284.91, 1e-9);
  EXPECT_EQ(bus.ear.refusals.size(), 1U);
}

TEST(DepthDriver, APressureDeeperThanAnySeaIsRefused) {
  Bus bus(options(Kind::depth, "nmea2000"));
  bus.says(pressure_id, {0, 0, 1, 0xFF, 0xFF, 0xFF, 0x7E, 0xFF});  // 2130706.431 hPa: 21 km down
  EXPECT_TRUE(bus.ear.heard.empty());
  EXPECT_EQ(bus.ear.refusals.size(), 1U);
}

TEST(MakeDriver, UnknownCombinationSaysWhichExist) {
  const auto made = make_byte_driver(options(Kind::gnss, "pd0"));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message,
            "no driver for kind \"gnss\" with protocol \"pd0\" over bytes; allowed: ubx (bytes) "
            "nmea0183 (bytes) ubx+nmea0183 (bytes) nmea2000 (CAN frames)");
  EXPECT_FALSE(make_frame_driver(options(Kind::depth, "pd0")));
}

TEST(MakeDriver, EveryListedCombinationIsMade) {
  for (const Kind kind :
       {Kind::dvl, Kind::emlog, Kind::gnss, Kind::imu, Kind::depth, Kind::actuator}) {
    EXPECT_FALSE(protocols_of(kind).empty());
    for (const ProtocolEntry& entry : protocols_of(kind)) {
      const DriverOptions o = options(kind, std::string(entry.name));
      EXPECT_EQ(make_byte_driver(o).has_value(), entry.travels == Travels::as_bytes);
      EXPECT_EQ(make_frame_driver(o).has_value(), entry.travels == Travels::as_frames);
    }
  }
}

}  // namespace bus_driver_test
}  // namespace drydock::device::test
