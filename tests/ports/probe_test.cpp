// `drydock probe` on lines that carry bytes at their rate and turn them into others at a wrong one,
// behind a 16550A and an FTDI adapter. Every rate and every frame of a byte:
// tests/drivers/probe/setting_search_test.cpp, in virtual time.
#include <gtest/gtest.h>

#include <future>

#include "drivers/probe/probe_report.hpp"
#include "tests/hil/survive/bench.hpp"
#include "tests/ports/driver.hpp"

namespace drydock::ports {
namespace {

/// `sent`: keys of the sensor's URI. `found`: those of them that a receiver can find out.
struct Case {
  std::string protocol, ours, theirs, sent, found;
};

rig_config::DeviceConfig sensor(const Case& line) {
  auto config = fault::testing::speed_log("serial:" + line.theirs + "?emulated=1&" + line.sent);
  config.name = line.theirs;
  config.protocol = line.protocol;
  if (line.protocol != "nmea0183") config.kind = rig_config::DeviceKind::dvl;
  config.rate_hz = 5;
  return config;
}

/// Those that were found; else what was said.
std::string found_by(const probe::ProbeReport& report) {
  std::string said;
  for (const auto& device : report.devices) said += device.protocol + " " + device.link + "\n";
  if (!said.empty()) return said;
  for (const auto& note : probe::all_notes(report)) said += note + "\n";
  return said;
}

/// QEMU's FTDI adapter has eight data bits whatever it is told, so seven are those of the 16550A.
const Case uart{"nmea0183", "/dev/ttyS4", "/dev/ttyS5", "baud=9600&parity=even&bits=7",
                "baud=9600&parity=even&bits=7"};
const Case ftdi{"pd0", "/dev/ttyUSB2", "/dev/ttyUSB3", "baud=115200&parity=even",
                "baud=115200&parity=even"};

/// A machine in software on a busy host stands still at times, and a probe then hears too little.
/// So each line is probed up to three times; what a probe says must be right.
TEST(APacedLine, IsProbedToItsRateItsParityAndItsProtocol) {
  runs_on({uart.ours, uart.theirs, ftdi.ours, ftdi.theirs});
  boost::asio::io_context io;
  rig_config::Rig rig;
  rig.devices = {sensor(uart), sensor(ftdi)};
  const motion::KinematicTrajectory trajectory({}, link::steady_now());
  fault::Injector injector(rig, trajectory, trajectory.start());
  emulate::RealTimeEmulator emulator(io, injector);
  ASSERT_TRUE(emulator.start(rig.devices));
  const auto probed = [](const Case& line) {
    probe::ProbeReport report;
    for (int time = 0; time < 3 && report.devices.empty(); ++time)
      report = probe::find_sensors("serial:" + line.ours, 30);
    return found_by(report);
  };
  auto on_uart = std::async(std::launch::async, probed, uart);
  auto on_ftdi = std::async(std::launch::async, probed, ftdi);
  const auto is_ready = [](auto& one) {
    return one.wait_for(std::chrono::seconds{0}) == std::future_status::ready;
  };
  while (!is_ready(on_uart) || !is_ready(on_ftdi)) io.run_for(std::chrono::milliseconds{50});
  emulator.stop();
  io.run_for(std::chrono::seconds{5});
  EXPECT_EQ(on_uart.get(), uart.protocol + " serial:" + uart.ours + "?" + uart.found + "\n");
  EXPECT_EQ(on_ftdi.get(), ftdi.protocol + " serial:" + ftdi.ours + "?" + ftdi.found + "\n");
}

}  // namespace
}  // namespace drydock::ports
