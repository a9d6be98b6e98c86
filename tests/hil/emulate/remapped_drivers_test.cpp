#include "drivers/device/make_driver.hpp"
#include "hil/emulate/lockstep.hpp"
#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/hil/emulate/bench.hpp"

/// Our drivers on emulated CANopen nodes whose PDOs another master has set up.
namespace drydock::emulate {
namespace remapped_drivers_test {

using rig_config::DeviceKind;

/// A driver and a node on one bus, and another master that speaks first.
struct Remapped final : device::Output {
  Remapped(const rig_config::DeviceConfig& config, device::DriverOptions options,
           std::initializer_list<const char*> master) {
    options.protocol = config.protocol;
    options.address = 1;
    driver = *device::make_frame_driver(options);
    bus.add(make_emulated_device(config, trajectory, 1).value());
    lockstep.add(bus);
    driver->restart(start, *this);
    double t = 0.1;
    for (const char* said : master) {
      bus.receive(wire::test::frame(said), at_s(t));
      run(t += 0.01);
    }
    run(8);
  }
  void run(double until_s) {
    for (; now < at_s(until_s); now += std::chrono::milliseconds{1}) {
      lockstep.run_until(now);
      if (driver->deadline() && *driver->deadline() <= now) driver->tick(now, *this);
    }
  }
  void publish(const measurement::Measurement& m) override { measurements.push_back(m); }
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame& frame) override { bus.receive(frame, now); }
  void report(std::string_view what) override { reports.emplace_back(what); }

  Frozen trajectory{under_way()};
  Stamp now = start;
  EmulatedBus bus{250'000,
                  [this](const wire::CanFrame& frame, std::size_t, const Passage& passage) {
                    driver->receive(frame, passage.ended_at, *this);
                  }};
  shell::Lockstep lockstep{start};
  std::unique_ptr<device::FrameDriver> driver;
  std::vector<measurement::Measurement> measurements;
  std::vector<std::string> reports;
};

TEST(RemappedDrivers, APressureComesFromThePdoThatAnotherMasterMapped) {
  device::DriverOptions options;
  options.kind = device::Kind::depth;
  const Remapped usual(device(DeviceKind::depth, "cia404-pressure", 10), options, {});
  const Remapped other(device(DeviceKind::depth, "cia404-pressure", 10), options,
                       {"601#2300180181010080", "601#2F001A0000000000", "601#23001A0108015061",
                        "601#23001A0220013091", "601#2F001A0002000000", "601#23001801C1010000"});
  EXPECT_TRUE(usual.reports.empty());
  EXPECT_EQ(other.reports,
            std::vector<std::string>{
                "node 1 was set up in another way; it is read as it says (1A00h): 1C1h"});
  ASSERT_GT(other.measurements.size(), 30u);
  const auto& expected = std::get<measurement::DepthSample>(usual.measurements.back());
  const auto& got = std::get<measurement::DepthSample>(other.measurements.back());
  EXPECT_EQ(got.pressure_pa, expected.pressure_pa);
}

TEST(RemappedDrivers, ADriveTellsItsPositionBesideItsMode) {
  device::DriverOptions options;
  options.kind = device::Kind::actuator;
  options.instance = 1;
  auto config = device(DeviceKind::actuator, "cia402", 10);
  config.instance = 1;
  config.address = 1;
  const Remapped usual(config, options, {});
  const Remapped other(config, options,
                       {"601#2300180181010080", "601#2F001A0000000000", "601#23001A0108006160",
                        "601#23001A0220006460", "601#23001A0310004160", "601#2F001A0003000000",
                        "601#2300180181010000"});
  EXPECT_EQ(other.reports,
            std::vector<std::string>{
                "node 1 was set up in another way; it is read as it says (1A00h): 181h"});
  ASSERT_GT(other.measurements.size(), 60u);
  const auto& expected = std::get<measurement::ActuatorState>(usual.measurements.back());
  const auto& got = std::get<measurement::ActuatorState>(other.measurements.back());
  EXPECT_EQ(got.stern_plane_rad, expected.stern_plane_rad);
  EXPECT_NEAR(got.stern_plane_rad.value(), under_way().stern_plane_rad, 1e-4);
}

}  // namespace remapped_drivers_test
}  // namespace drydock::emulate
