// The command `proxy`: what it refuses, and one complete connection through it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/hil/program/program.hpp"

namespace program_proxy_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;

TEST(Program, AProxyRefusesWhatARealDeviceCannotBeMadeToDo) {
  const Folder folder;
  std::ofstream(folder / "f.toml") << "[[fault]]\ndevice = \"dvl\"\nfault = \"off\"\n"
                                      "[[fault]]\ndevice = \"dvl\"\nfault = \"bottom-lost\"\n";
  const auto proxy = drydock(
      "proxy 'serial:/dev/null?baud=9600' pty:dvl --protocol pd0 --device dvl "
      "--faults " +
      (folder / "f.toml").string());
  EXPECT_EQ(proxy.exit_code, 2);
  EXPECT_THAT(proxy.output, HasSubstr("f.toml:1:1: /fault: dvl \"dvl\" (pd0) cannot have the fault "
                                      "\"off\": behind the wire is a real device"));
  EXPECT_THAT(proxy.output, HasSubstr("f.toml:4:1: /fault"));
  EXPECT_THAT(proxy.output, HasSubstr("bottom-lost"));
}

TEST(Program, AProxyRefusesLinksThatDoNotFitEachOther) {
  const auto mixed = drydock("proxy pty:a socketcan:vcan0");
  EXPECT_EQ(mixed.exit_code, 2);
  EXPECT_EQ(mixed.output, "proxy: pty:a carries bytes, socketcan:vcan0 does not\n");
  EXPECT_EQ(drydock("proxy pty:a pty:a").exit_code, 2);
  EXPECT_EQ(drydock("proxy file:dive.mcap pty:a").exit_code, 2);
  EXPECT_EQ(drydock("proxy pty:a pty:b --protocol xsens").exit_code, 2);
  const auto slcan = drydock("proxy socketcan:can0 slcan:pty:a --faults /dev/null");
  EXPECT_EQ(slcan.exit_code, 2);
}

// Three programs: an emulated log, the proxy, and a reader in place of a driver.
TEST(Program, AProxyPassesAnEmulatedDeviceOnAndSumsUp) {
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"log\"\n[[device]]\nname = \"log\"\nkind = \"emlog\"\n"
         "protocol = \"nmea0183\"\nlink = \"pty:real?baud=38400\"\nrate_hz = 20\n";
  std::ofstream(folder / "f.toml")
      << "[[fault]]\ndevice = \"log\"\nfault = \"drop\"\nprobability = 0.5\n";
  const auto run =
      drydock("emulate " + (folder / "rig.toml").string() + " > /dev/null & " +
              program::until_linked("real") +
              DRYDOCK_PROGRAM
              " proxy 'pty:real?baud=38400' pty:log --protocol nmea0183 --device log --faults " +
              (folder / "f.toml").string() + " --for 3s --json 2>/dev/null; kill $!; wait");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto summary = nlohmann::json::parse(run.output);
  EXPECT_GT(summary["from_device"], 500);
  EXPECT_LT(summary["to_drivers"], summary["from_device"]);
  EXPECT_GT(summary["faults"]["drop"], 10);
  EXPECT_EQ(summary["lost"], 0);
}

}  // namespace program_proxy_test
