#include <gmock/gmock.h>

#include "drivers/doctor/ports.hpp"
#include "drivers/probe/probe.hpp"
#include "tests/drivers/decode/captured.hpp"
#include "tests/drivers/doctor/machine.hpp"

/// CAN interfaces, and the modules that adapters and interfaces need.
namespace drydock::doctor {
namespace can_interfaces_test {

using testing::HasSubstr;

TEST(Ports, CanInterfacesAreToldFromOtherNetworks) {
  Machine machine;
  machine.file("sys/class/net/eth0/type", "1\n");
  machine.file("sys/class/net/can0/type", "280\n");
  machine.file("sys/class/net/can0/operstate", "down\n");
  const auto ports = can_ports(machine.root());
  ASSERT_EQ(ports.size(), 1u);
  EXPECT_EQ(ports[0].name, "can0");
  EXPECT_FALSE(ports[0].up);
  decode::MemoryFile out;
  EXPECT_EQ(probe::probe_all(machine.root(), true, out.file()), 0);
  EXPECT_EQ(nlohmann::json::parse(out.text()).at("can").at(0).at("name"), "can0");
}

TEST(Doctor, AnAdapterWithoutADriverIsToldItsModule) {
  Machine machine;
  machine.file("proc/sys/kernel/osrelease", "6.1.0-test\n");
  // As depmod writes them (modules.alias, modules.dep), and sysfs.
  machine.file("lib/modules/6.1.0-test/modules.alias",
               "# Aliases extracted from modules themselves.\n"
               "alias usb:v1D50p606Fd*dc*dsc*dp*ic*isc*ip*in00* gs_usb\n"
               "alias usb:v*p*d*dc*dsc*dp*ic02isc02ip01in* cdc_acm\n"
               "alias usb:v*p*d*dc*dsc*dp*ic03isc*ip*in* usbhid\n"
               "alias spi:mcp2515 mcp251x\n");
  machine.file("lib/modules/6.1.0-test/modules.dep",
               "kernel/drivers/net/can/usb/gs_usb.ko.xz: kernel/drivers/net/can/dev/can-dev.ko.xz\n"
               "kernel/drivers/net/can/spi/mcp251x.ko: kernel/drivers/net/can/dev/can-dev.ko\n"
               "kernel/drivers/usb/class/cdc-acm.ko.xz:\n"
               "kernel/drivers/hid/usbhid/usbhid.ko.xz:\n");
  const auto device = [&](const std::string& path, const std::string& alias) {
    machine.file(path + "/modalias", alias + "\n");
  };
  device("sys/bus/usb/devices/1-2:1.0", "usb:v1D50p606Fd0100dcEFdsc02dp01icFFiscFFipFFin00");
  device("sys/bus/usb/devices/1-3:1.0", "usb:v2341p0043d0001dc02dsc00dp00ic02isc02ip01in00");
  device("sys/bus/usb/devices/1-4:1.0", "usb:v046Dp0000d0001dc00dsc00dp00ic03isc01ip01in00");
  device("sys/bus/spi/devices/spi0.0", "spi:mcp2515");
  machine.link("sys/bus/usb/devices/1-3:1.0/driver", "../cdc_acm");
  machine.file("sys/bus/usb/devices/cdc_acm", "");
  const auto commands = [&] {
    std::vector<std::string> all;
    for (const auto& one : check_drivers(machine.root(), Needs{})) all.push_back(one.command);
    return all;
  };
  EXPECT_THAT(commands(), testing::ElementsAre("sudo modprobe gs_usb", "sudo modprobe mcp251x"));
  machine.file("sys/module/gs_usb/refcnt", "0\n");
  EXPECT_THAT(commands(), testing::ElementsAre("sudo modprobe mcp251x"));
  Needs none;
  none.whole_machine = false;
  EXPECT_TRUE(check_drivers(machine.root(), none).empty());
}

TEST(Doctor, AModuleIsMissingOnlyWhereTheRigNeedsIt) {
  Machine machine;
  machine.file("proc/sys/kernel/osrelease", "6.1.0-test\n");
  machine.file("lib/modules/6.1.0-test/modules.builtin", "kernel/net/can/can.ko\n");
  machine.file("sys/module/can_raw/refcnt", "0\n");
  Needs needs;
  needs.whole_machine = false;
  EXPECT_TRUE(check_can(machine.root(), needs).empty());
  needs.kernel_can = true;
  needs.buses = {"vcan3"};
  const auto found = check_can(machine.root(), needs);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].fitness, Fitness::ok);
  EXPECT_EQ(found[1].fitness, Fitness::ok);
  EXPECT_EQ(found[2].command, "sudo modprobe vcan");
  EXPECT_THAT(found[3].command, HasSubstr("sudo ip link add vcan3 type vcan"));
}

/// gs_usb of Linux 6.1 has no do_set_mode, and `ip` then refuses restart-ms.
TEST(Doctor, RestartMsIsAdvisedOnlyWhereTheControllersDriverHasIt) {
  Machine machine;
  for (const char* name : {"can0", "can2"}) {
    machine.file(std::string("sys/class/net/") + name + "/type", "280\n");
    machine.file(std::string("sys/class/net/") + name + "/operstate", "down\n");
  }
  machine.file("sys/bus/usb/drivers/gs_usb/module", "");
  machine.link("sys/class/net/can2/device/driver", "../../../../bus/usb/drivers/gs_usb");
  Needs needs{.whole_machine = false,
              .rig_file = {},
              .ports = {},
              .buses = {"can0", "can2"},
              .bitrates = {{"can0", 500000}},
              .kernel_can = true};
  std::vector<std::string> commands;
  for (const auto& one : check_can(machine.root(), needs))
    if (one.check == "CAN") commands.push_back(one.command);
  EXPECT_THAT(commands, testing::ElementsAre(
                            "sudo ip link set can0 down; "
                            "sudo ip link set can0 up type can bitrate 500000 restart-ms 100",
                            "sudo ip link set can2 down; "
                            "sudo ip link set can2 up type can bitrate 250000"));
}

TEST(Doctor, AShortSendQueueOfACanInterfaceIsLengthened) {
  Machine machine;
  machine.file("sys/class/net/can0/type", "280\n");
  machine.file("sys/class/net/can0/tx_queue_len", "10\n");
  Needs needs{.whole_machine = false,
              .rig_file = {},
              .ports = {},
              .buses = {"can0"},
              .bitrates = {},
              .kernel_can = true};
  const auto commands = [&] {
    std::vector<std::string> all;
    for (const auto& one : check_can(machine.root(), needs)) all.push_back(one.command);
    return all;
  };
  EXPECT_THAT(commands(), testing::Contains("sudo ip link set can0 txqueuelen 1000"));
  machine.file("sys/class/net/can0/tx_queue_len", "1000\n");
  EXPECT_THAT(commands(), testing::Not(testing::Contains(HasSubstr("txqueuelen"))));
}

}  // namespace can_interfaces_test
}  // namespace drydock::doctor
