// Real links, real time: what is tested here is a proxy's meeting with the operating system. What
// faults do to what passes is tested in virtual time beside this.
#include "hil/proxy/proxy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/shell/real_time.hpp"
#include "hil/emulate/real_time.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/drivers/link/running.hpp"
#include "tests/hil/proxy/outlet.hpp"

namespace proxy_test {

using namespace drydock;
using namespace drydock::link::testing;
using fault::FaultKind;
using fault::testing::fault_of;
namespace asio = boost::asio;
using link::Side;
using ::testing::Contains;
using ::testing::HasSubstr;

/// A proxy between two ends that the test holds, each a URI.
class ProxyBetween {
 public:
  ProxyBetween(const std::string& real, const std::string& virt,
               const std::string& protocol = "nmea0183")
      : schedule(std::make_shared<fault::Schedule>(link::now())) {
    proxy::ProxyOptions options;
    options.real = link::parse_uri(real).value();
    options.virt = link::parse_uri(virt).value();
    options.device.name = "device";
    options.device.protocol = protocol;
    options.device.link = real;
    options.schedule = schedule;
    options.say = [this](const std::string& line) { said.push_back(line); };
    proxy = proxy::Proxy::start(io, std::move(options));
  }
  ~ProxyBetween() {
    proxy->finish();
    io.restart();
    io.run_for(5s);
    EXPECT_TRUE(io.stopped()) << "a coroutine still waits";
  }

  bool until_said(const std::string& part, std::size_t times = 1) {
    return run_until(io, [&] {
      return static_cast<std::size_t>(std::ranges::count_if(said, [&](const auto& line) {
               return line.find(part) != std::string::npos;
             })) >= times;
    });
  }
  void set(const std::string& keys) {
    schedule->set(fault_of("device='device'\n" + keys), link::now());
    proxy->rearm();
  }
  void clear() {
    schedule->clear();
    proxy->rearm();
  }

  asio::io_context io{1};
  std::shared_ptr<fault::Schedule> schedule;
  std::vector<std::string> said;
  std::unique_ptr<proxy::Proxy> proxy;
};

std::string unique(const std::string& name) { return name + "-" + std::to_string(::getpid()); }

/// The device on a pty, the drivers on another.
class ByteProxy : public ::testing::Test {
 protected:
  ByteProxy() {
    device_ = open(between_.io, real_, Side::device);
    EXPECT_TRUE(between_.until_said("drivers: "));
    drivers_ = open(between_.io, virtual_, Side::driver);
  }
  ~ByteProxy() override {
    device_->close();
    drivers_->close();
    settle(between_.io);
  }

  std::string heard(std::size_t size) {
    const auto read = run(between_.io, read_bytes(*drivers_, size));
    return read ? std::string(read->begin(), read->end()) : "";
  }
  void say(const std::string& text) { ASSERT_TRUE(run(between_.io, device_->write(bytes(text)))); }

  std::string real_ = "pty:" + unique("proxy-real"), virtual_ = "pty:" + unique("proxy-virtual");
  ProxyBetween between_{real_, virtual_};
  std::unique_ptr<link::ByteLink> device_, drivers_;
};

TEST_F(ByteProxy, PassesBothWaysAndCounts) {
  say("hello");
  EXPECT_EQ(heard(5), "hello");
  ASSERT_TRUE(run(between_.io, drivers_->write(bytes("set"))));
  const auto read = run(between_.io, read_bytes(*device_, 3));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, bytes("set"));
  const auto passed = between_.proxy->passed();
  EXPECT_EQ(passed.from_device, 5u);
  EXPECT_EQ(passed.to_drivers, 5u);
  EXPECT_EQ(passed.from_drivers, 3u);
  EXPECT_EQ(passed.to_device, 3u);
  EXPECT_EQ(passed.lost, 0u);
  EXPECT_TRUE(between_.proxy->hits().none());
  EXPECT_EQ(between_.proxy->latency().count(), 1u);
}

TEST_F(ByteProxy, AFaultSetWhileItRunsHitsAndClears) {
  const auto& gga = fault::testing::gga;
  between_.set("fault='drop'\nprobability=1.0");
  say(gga);
  run_until(between_.io, [&] { return between_.proxy->hits()[FaultKind::drop] == 1; });
  between_.clear();
  say("after");
  EXPECT_EQ(heard(5), "after");
  EXPECT_EQ(between_.proxy->hits()[FaultKind::drop], 1u);
}

TEST_F(ByteProxy, WhatADelayHoldsComesByItself) {
  between_.set("fault='delay'\nseconds=0.05");
  const auto before = link::now();
  say(fault::testing::gga);
  EXPECT_EQ(heard(fault::testing::gga.size()), fault::testing::gga);
  EXPECT_GE(link::now() - before, 50ms);
}

TEST_F(ByteProxy, UnpluggedTheVirtualSideVanishesAndComesBackAndTheRealOneStays) {
  between_.set("fault='unplug'");
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_FALSE(run(between_.io, drivers_->read(buffer)));  // the line is gone
  drivers_->close();
  EXPECT_FALSE(link::open_bytes(between_.io.get_executor(), link::parse_uri(virtual_).value(),
                                Side::driver));
  say("lost");
  run_until(between_.io, [&] { return between_.proxy->passed().from_device == 4; });
  between_.clear();
  ASSERT_TRUE(between_.until_said("drivers: ", 2));
  drivers_ = open(between_.io, virtual_, Side::driver);
  say("back");
  EXPECT_EQ(heard(4), "back");
  EXPECT_EQ(between_.proxy->hits()[FaultKind::unplug], 1u);
}

TEST_F(ByteProxy, AtEndOfFileTheVirtualSideHangsUpOnceAndCanBeOpenedAgain) {
  between_.set("fault='eof'");
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_FALSE(run(between_.io, drivers_->read(buffer)));
  drivers_->close();
  ASSERT_TRUE(between_.until_said("drivers: ", 2));
  drivers_ = open(between_.io, virtual_, Side::driver);
  say("again");
  EXPECT_EQ(heard(5), "again");
}

TEST_F(ByteProxy, HungNothingPassesEitherWay) {
  between_.set("fault='hang'");
  say("unheard");
  ASSERT_TRUE(run(between_.io, drivers_->write(bytes("unheard too"))));
  settle(between_.io);
  between_.clear();
  settle(between_.io);
  say("heard");
  EXPECT_EQ(heard(5), "heard");
  EXPECT_EQ(between_.proxy->passed().to_device, 0u);
}

TEST_F(ByteProxy, ARealSideThatGoesIsToldOfOnceTakesTheVirtualOneAlongAndComesBack) {
  device_->close();
  ASSERT_TRUE(between_.until_said("retry"));
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_FALSE(run(between_.io, drivers_->read(buffer)));
  drivers_->close();
  between_.io.restart();
  between_.io.run_for(900ms);  // it tries in vain
  const auto lines = between_.said.size();
  EXPECT_EQ(lines, 3u) << between_.said.back();
  device_ = open(between_.io, real_, Side::device);
  ASSERT_TRUE(between_.until_said("drivers: ", 2));
  drivers_ = open(between_.io, virtual_, Side::driver);
  say("back");
  EXPECT_EQ(heard(4), "back");
}

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

// Emulated DVL, pty, proxy, pty, driver.
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
  devices.push_back(std::move(*device::Device::make(options)));
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

TEST(Latency, ItsPercentilesAreWithinAnEighthOfAnOctave) {
  proxy::Latency latency;
  EXPECT_EQ(latency.percentile(0.99).count(), 0);
  for (int us = 1; us <= 1000; ++us) latency.add(std::chrono::microseconds{us});
  EXPECT_NEAR(static_cast<double>(latency.percentile(0.5).count()), 500e3, 500e3 * 0.1);
  EXPECT_NEAR(static_cast<double>(latency.percentile(0.99).count()), 990e3, 990e3 * 0.1);
}

}  // namespace proxy_test
