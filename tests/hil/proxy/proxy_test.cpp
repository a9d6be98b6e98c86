// A proxy on TCP, on CAN, and between an emulated DVL and its driver.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "drivers/shell/real_time.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "tests/hil/proxy/proxy_between.hpp"

namespace proxy_test {

using namespace drydock;
using namespace drydock::proxy::testing;
using fault::FaultKind;
using link::Side;
using ::testing::HasSubstr;

TEST(Proxy, OfATcpDeviceThatIsNotThereYetIsToldOnceAndComesWhenItIs) {
  const std::string real = "tcp:127.0.0.1:" + std::to_string(20'000 + ::getpid() % 20'000);
  ProxyBetween between(real, "memory:" + unique("proxy-tcp"));
  between.io.run_for(600ms);
  ASSERT_EQ(between.said.size(), 1u);
  EXPECT_THAT(between.said[0], HasSubstr("refused"));
  const auto device = open(between.io, real, Side::device);
  EXPECT_TRUE(between.until_said("drivers: memory:"));
  const auto drivers = open(between.io, "memory:" + unique("proxy-tcp"), Side::driver);
  ASSERT_TRUE(run(between.io, device->write(bytes("hello"))));
  const auto read = run(between.io, read_bytes(*drivers, 5));
  EXPECT_TRUE(read && *read == bytes("hello"));
  device->close();
  drivers->close();
  settle(between.io);
}

wire::CanFrame frame(std::uint32_t id) {
  wire::CanFrame made;
  made.id = id;
  made.size = 2;
  return made;
}

TEST(BusProxy, PassesFramesBothWaysAndTellsDriversOfABusThatIsOff) {
  const std::string real = "memory-can:" + unique("real"), virt = "memory-can:" + unique("virtual");
  ProxyBetween between(real, virt, "cia404-imu");
  ASSERT_TRUE(between.until_said("drivers: "));
  const auto device = open_bus(between.io, real, Side::driver);
  const auto drivers = open_bus(between.io, virt, Side::driver);
  const auto heard = [&](link::FrameLink& by) {
    const auto read = run(between.io, by.read());
    return read ? read->frame : wire::CanFrame{};
  };
  ASSERT_TRUE(run(between.io, device->write(frame(0x181))));
  EXPECT_EQ(heard(*drivers), frame(0x181));
  ASSERT_TRUE(run(between.io, drivers->write(frame(0x601))));
  EXPECT_EQ(heard(*device), frame(0x601));

  between.set("fault='bus-off'");
  EXPECT_EQ(heard(*drivers).id, 0x040u);  // linux/can/error.h: CAN_ERR_BUSOFF
  ASSERT_TRUE(run(between.io, device->write(frame(0x182))));
  settle(between.io);
  between.clear();
  EXPECT_EQ(heard(*drivers).id, 0x100u);  // CAN_ERR_RESTARTED
  ASSERT_TRUE(run(between.io, device->write(frame(0x183))));
  EXPECT_EQ(heard(*drivers), frame(0x183));
  EXPECT_EQ(between.proxy->hits()[FaultKind::bus_off], 1u);
  device->close();
  drivers->close();
  settle(between.io);
}

struct Measurements final : device::Listener {
  void on_measurement(const measurement::Measurement&) override { ++count; }
  void on_state(const device::Device&, const device::Transition&) override {}
  int count = 0;
};

// The chain is emulated DVL, pty, proxy, pty, driver.
TEST(Proxy, ADvlBehindItIsSoundToItsDriverAndEachOfItsReportsSurvives) {
  const std::string real = "pty:" + unique("proxied-dvl") + "?baud=115200";
  const std::string virt = "pty:" + unique("dvl") + "?baud=115200";
  ProxyBetween between(real, virt, "pd0");
  const motion::KinematicTrajectory trajectory(rig_config::MissionConfig{}, link::now());
  emulate::SoundDevices at_sea(trajectory, 1);
  emulate::RealTimeEmulator emulator(between.io, at_sea);
  rig_config::DeviceConfig dvl;
  dvl.name = "dvl";
  dvl.kind = rig_config::DeviceKind::dvl;
  dvl.protocol = "pd0";
  dvl.link = real;
  dvl.rate_hz = 20;
  ASSERT_TRUE(emulator.start({dvl}));
  ASSERT_TRUE(between.until_said("drivers: "));

  device::DeviceOptions options;
  options.name = "dvl";
  options.link = virt;
  options.driver.kind = device::Kind::dvl;
  options.driver.protocol = "pd0";
  options.driver.baud = 115'200;
  std::vector<std::unique_ptr<device::Device>> devices;
  devices.push_back(*device::Device::make(options));
  Measurements measurements;
  shell::RealTime drivers(between.io, std::move(devices), measurements);
  drivers.start();

  EXPECT_TRUE(run_until(between.io, [&] { return measurements.count >= 8; }));
  const auto sound = drivers.health(0).stream;
  EXPECT_EQ(sound.bad_checksums, 0u);
  EXPECT_TRUE(between.proxy->hits().none());

  between.set("fault='bad-checksum'\nprobability=1.0");
  EXPECT_TRUE(
      run_until(between.io, [&] { return between.proxy->hits()[FaultKind::bad_checksum] >= 4; }));
  between.clear();
  const auto before = measurements.count;
  EXPECT_TRUE(run_until(between.io, [&] { return measurements.count >= before + 4; }));
  EXPECT_GE(drivers.health(0).stream.bad_checksums, 4u);
  emulator.stop();
  drivers.stop();
  settle(between.io);
}

}  // namespace proxy_test
