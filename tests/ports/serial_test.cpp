// Every protocol that goes over a serial line, through the kernel's drivers for a 16550A and an
// FTDI adapter.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "drivers/link/uri.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/survive/bench.hpp"
#include "tests/ports/driver.hpp"
#include "tests/test_name.hpp"

namespace drydock::ports {
namespace {

using device::State;
using fault::testing::Bench;

struct Line {
  std::string driver, ours,
      sensors;  ///< of the kernel; the driver's end, the emulated sensor's end
};
const Line uart{"16550A", "/dev/ttyS1", "/dev/ttyS2"};
const Line ftdi{"ftdi_sio", "/dev/ttyUSB0", "/dev/ttyUSB1"};

/// The lines of the machine in software, or the two ports in DRYDOCK_PORTS, joined by a null-modem
/// cable.
std::vector<Line> lines() {
  const char* own = std::getenv("DRYDOCK_PORTS");
  if (own == nullptr) return {uart, ftdi};
  Line line{"own", "", ""};
  std::istringstream(own) >> line.ours >> line.sensors;
  return {line};
}

unsigned baud_of(const rig_config::DeviceConfig& device) {
  return link::parse_uri(device.link)->baud().value_or(115200);
}

rig_config::DeviceConfig at_baud(rig_config::DeviceConfig device, unsigned baud) {
  device.link = "serial:/dev/tty?baud=" + std::to_string(baud);
  device.name += "_" + std::to_string(baud);
  return device;
}

/// The devices of the shipped rig with every protocol that have a line of their own, each at its
/// rate there. NMEA 0183 and UBX have more than one usual rate.
std::vector<rig_config::DeviceConfig> byte_devices() {
  std::vector<rig_config::DeviceConfig> devices;
  for (const auto& device :
       rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/every-protocol.toml")
           .value()
           .devices) {
    if (link::parse_uri(device.link)->carries() != link::Carries::bytes) continue;
    std::vector<unsigned> rates{baud_of(device)};
    if (device.name == "emlog") rates = {4800, 9600};
    if (device.name == "ubx") rates = {9600, 38400, 115200};
    for (const unsigned baud : rates) devices.push_back(at_baud(device, baud));
  }
  return devices;
}

rig_config::DeviceConfig on_port(rig_config::DeviceConfig device, const std::string& port) {
  device.link = "serial:" + port + "?emulated=1&baud=" + std::to_string(baud_of(device));
  return device;
}

class EveryByteProtocol
    : public ::testing::TestWithParam<std::tuple<Line, rig_config::DeviceConfig>> {};

TEST_P(EveryByteProtocol, ComesThroughTheKernelsDriverWhole) {
  const auto& [line, device] = GetParam();
  runs_on({line.ours, line.sensors});
  Bench bench(on_port(device, line.ours), on_port(device, line.sensors));
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  ASSERT_TRUE(bench.until([&] { return bench.messages >= 5; })) << bench.messages;

  const auto health = bench.health();
  EXPECT_EQ(health.stream.bad_checksums, 0u);
  EXPECT_EQ(health.stream.bytes_in,
            health.stream.bytes_good + health.stream.bytes_skipped + health.held_bytes);
  EXPECT_EQ(health.reopened, 0u);
}

INSTANTIATE_TEST_SUITE_P(Ports, EveryByteProtocol,
                         ::testing::Combine(::testing::ValuesIn(lines()),
                                            ::testing::ValuesIn(byte_devices())),
                         [](const auto& one) {
                           return test::test_name(std::get<0>(one.param).driver + "_" +
                                                  std::get<1>(one.param).name);
                         });

}  // namespace
}  // namespace drydock::ports
