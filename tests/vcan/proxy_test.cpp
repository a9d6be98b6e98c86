// A proxied bus whose drivers' side is an interface of the kernel. The error frames of a fault
// reach every socket that asked for them.
#include "hil/proxy/proxy.hpp"

#include <gtest/gtest.h>

#include "drivers/link/clock.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/load.hpp"
#include "tests/drivers/link/running.hpp"
#include "tests/vcan/process.hpp"

namespace proxy_on_vcan_test {

using namespace drydock;
using namespace drydock::link::testing;
using link::Side;

wire::CanFrame frame(std::uint32_t id) {
  wire::CanFrame made;
  made.id = id;
  made.size = 1;
  return made;
}

TEST(ProxyOnVcan, FramesPassAndABusThatIsOffIsToldAsAControllerTellsIt) {
  boost::asio::io_context io{1};
  const std::string virt = "socketcan:" + vcan::interface();
  proxy::ProxyOptions options;
  options.real = link::parse_uri("memory-can:proxied").value();
  options.virt = link::parse_uri(virt).value();
  options.device.name = "imu";
  options.device.protocol = "cia404-imu";
  options.device.link = "memory-can:proxied";
  options.schedule = std::make_shared<fault::Schedule>(link::steady_now());
  bool is_there = false;
  options.say = [&](const std::string& line) {
    is_there = is_there || line.starts_with("drivers");
  };
  const auto schedule = options.schedule;
  const auto proxy = proxy::Proxy::start(io, std::move(options));
  ASSERT_TRUE(run_until(io, [&] { return is_there; }));
  const auto device = open_bus(io, "memory-can:proxied", Side::driver);
  const auto drivers = open_bus(io, virt, Side::driver);

  ASSERT_TRUE(run(io, device->write(frame(0x181))));
  EXPECT_EQ(run(io, drivers->read())->frame, frame(0x181));
  ASSERT_TRUE(run(io, drivers->write(frame(0x601))));
  EXPECT_EQ(run(io, device->read())->frame, frame(0x601));

  rig_config::FaultConfig off;
  off.device = "imu";
  off.kind = fault::FaultKind::bus_off;
  schedule->set(off, link::steady_now());
  proxy->rearm();
  const auto told = run(io, drivers->read());
  ASSERT_TRUE(told);
  EXPECT_TRUE(told->frame.error);
  EXPECT_EQ(told->frame.id, 0x040u);  // linux/can/error.h: CAN_ERR_BUSOFF
  schedule->clear();
  proxy->rearm();
  EXPECT_EQ(run(io, drivers->read())->frame.id, 0x100u);  // CAN_ERR_RESTARTED

  device->close();
  drivers->close();
  proxy->finish();
  settle(io);
}

}  // namespace proxy_on_vcan_test
