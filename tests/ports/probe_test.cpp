// `drydock probe` on lines that carry bytes at their rate and turn them into others at a wrong one
// (with-ports.py --paced). Each case has one sensor behind the 16550A and one behind the FTDI
// adapter, at two rates and with two settings.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "tests/vcan/process.hpp"

namespace drydock::ports {
namespace {

using vcan::Process;

/// `settings`: keys of the URI. `found`: those of them that a receiver can find out. It looks at
/// the first stop bit alone, so a second one does not show.
struct Sensor {
  std::string kind, protocol, baud, settings, found;
  std::string name() const { return baud + settings; }
};
struct Case {
  Sensor uart, ftdi;
  friend void PrintTo(const Case& c, std::ostream* out) {
    *out << c.uart.name() << ", " << c.ftdi.name();
  }
};

std::string device(const std::string& name, const Sensor& sensor, const std::string& port) {
  return "\n[[device]]\nname = \"" + name + "\"\nkind = \"" + sensor.kind + "\"\nprotocol = \"" +
         sensor.protocol + "\"\nlink = \"serial:" + port + "?emulated=1&baud=" + sensor.baud +
         sensor.settings + "\"\nrate_hz = 5\n";
}

std::string rig_file(const Case& sensors) {
  const std::string path = ::testing::TempDir() + "probed.toml";
  std::ofstream(path) << "[rig]\nname = \"probed\"\nseed = 1\nstart = 2026-11-21T08:00:00Z\n"
                         "mission = \"" DRYDOCK_SOURCE_DIR
                         "/rig_config/missions/s-path.toml\"\n"
                         "publish = false\n"
                      << device("uart", sensors.uart, "/dev/ttyS2")
                      << device("ftdi", sensors.ftdi, "/dev/ttyUSB1");
  return path;
}

/// The probe's rig entry, or what it said instead. output_until() waits for 20 s at most.
std::string found_by(Process& probe) {
  std::string said;
  for (int i = 0; i < 3 && said.find("rate_hz") == said.npos; ++i)
    said = probe.output_until("rate_hz");
  return said;
}

std::string entry(const Sensor& sensor, const std::string& port) {
  return "protocol = \"" + sensor.protocol + "\"\nlink = \"serial:" + port +
         "?baud=" + sensor.baud + sensor.found + "\"";
}

class APacedLine : public ::testing::TestWithParam<Case> {};

/// A machine in software on a busy host stands still at times, and a probe then hears too little.
/// So each line is probed up to three times; what a probe says must be right.
TEST_P(APacedLine, IsProbedToItsRateItsParityAndItsProtocol) {
  Process emulator({DRYDOCK_PROGRAM, "emulate", rig_file(GetParam())});
  ASSERT_NE(emulator.output_until("ftdi:").find("ftdi:"), std::string::npos);
  const auto& [u, f] = GetParam();
  std::string uart, ftdi;
  const auto is_found = [](const std::string& said) { return said.find("rate_hz") != said.npos; };
  for (int time = 0; time < 3 && !(is_found(uart) && is_found(ftdi)); ++time) {
    Process on_uart({DRYDOCK_PROGRAM, "probe", "serial:/dev/ttyS1"});
    Process on_ftdi({DRYDOCK_PROGRAM, "probe", "serial:/dev/ttyUSB0"});
    uart = found_by(on_uart);
    ftdi = found_by(on_ftdi);
  }
  EXPECT_NE(uart.find(entry(u, "/dev/ttyS1")), uart.npos) << uart;
  EXPECT_NE(ftdi.find(entry(f, "/dev/ttyUSB0")), ftdi.npos) << ftdi;
}

const std::string even = "&parity=even", seven = "&parity=even&bits=7", two_stops = "&stop=2";
/// QEMU's FTDI adapter has eight data bits whatever it is told, so seven are those of the 16550A.
const std::vector<Case> cases{
    {{"dvl", "pd0", "115200", even, even}, {"emlog", "nmea0183", "4800", "", ""}},
    {{"emlog", "nmea0183", "9600", seven, seven}, {"dvl", "pd0", "57600", two_stops, ""}},
    {{"dvl", "pd0", "38400", "", ""}, {"emlog", "nmea0183", "19200", even, even}}};

INSTANTIATE_TEST_SUITE_P(Rates, APacedLine, ::testing::ValuesIn(cases), [](const auto& one) {
  std::string name = one.param.uart.name() + "_" + one.param.ftdi.name();
  std::ranges::replace_if(
      name, [](char c) { return c == '&' || c == '='; }, '_');
  return name;
});

}  // namespace
}  // namespace drydock::ports
