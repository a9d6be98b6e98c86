#include "drivers/doctor/doctor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/timex.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "drivers/doctor/ports.hpp"
#include "drivers/probe/probe.hpp"
#include "tests/drivers/decode/captured.hpp"

namespace drydock::doctor {
namespace doctor_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A machine that consists of files: its /sys, /proc, /dev, /etc.
class Machine {
 public:
  Machine() {
    auto name = (fs::temp_directory_path() / "drydock-machine-XXXXXX").string();
    root_ = mkdtemp(name.data());
  }
  ~Machine() { fs::remove_all(root_); }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  void file(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }
  void link(const std::string& path, const std::string& target) {
    fs::create_directories((root_ / path).parent_path());
    fs::create_symlink(target, root_ / path);
  }
  /// A USB serial adapter with an FTDI chip, as ttyUSB0.
  void plug_in() {
    file("sys/devices/usb1/1-2/idVendor", "0403\n");
    file("sys/devices/usb1/1-2/idProduct", "6001\n");
    file("sys/devices/usb1/1-2/product", "FT232R USB UART\n");
    file("sys/devices/usb1/1-2/ttyUSB0/port", "");
    file("sys/bus/usb-serial/drivers/ftdi_sio/module", "");
    link("sys/devices/usb1/1-2/ttyUSB0/driver", root() + "/sys/bus/usb-serial/drivers/ftdi_sio");
    link("sys/class/tty/ttyUSB0/device", root() + "/sys/devices/usb1/1-2/ttyUSB0");
    file("sys/bus/usb-serial/devices/ttyUSB0/latency_timer", "16\n");
    link("dev/serial/by-id/usb-FTDI_FT232R_A900-if00-port0", "../../ttyUSB0");
    file("dev/ttyUSB0", "");
    ::chmod((root() + "/dev/ttyUSB0").c_str(), 0660);
  }
  std::string root() const { return root_.string(); }

 private:
  fs::path root_;
};

Needs rig_with(const std::string& port) {
  Needs needs;
  needs.whole_machine = false;
  needs.ports = {port};
  return needs;
}

const Diagnosis* worst(const std::vector<Diagnosis>& all) {
  const auto found = std::ranges::max_element(all, {}, &Diagnosis::fitness);
  return found == all.end() ? nullptr : &*found;
}

TEST(Ports, ASerialAdapterIsNamedWithItsChipAndItsLastingName) {
  Machine machine;
  machine.plug_in();
  machine.file("sys/class/tty/console/active", "tty0\n");
  const auto ports = serial_ports(machine.root());
  ASSERT_EQ(ports.size(), 1u);
  EXPECT_EQ(ports[0].path, "/dev/ttyUSB0");
  EXPECT_EQ(ports[0].driver, "ftdi_sio");
  EXPECT_EQ(ports[0].usb_id, "0403:6001");
  EXPECT_EQ(ports[0].product, "FT232R USB UART");
  EXPECT_EQ(ports[0].by_id, "/dev/serial/by-id/usb-FTDI_FT232R_A900-if00-port0");
}

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

TEST(Doctor, AStrangerToThePortsGroupIsToldHowToJoinIt) {
  Machine machine;
  machine.plug_in();
  struct stat info {};
  ASSERT_EQ(::stat((machine.root() + "/dev/ttyUSB0").c_str(), &info), 0);
  machine.file("etc/group", "root:x:99999:\ndialout:x:" + std::to_string(info.st_gid) + ":\n");
  machine.file("proc/self/status", "Uid:\t77777\t77777\t77777\t77777\nGroups:\t4 24 \n");
  const auto refused = check_ports(machine.root(), rig_with("/dev/ttyUSB0"));
  EXPECT_EQ(refused.at(0).fitness, Fitness::wrong);
  EXPECT_THAT(refused.at(0).command, HasSubstr("sudo usermod -aG dialout $USER"));
  machine.file("proc/self/status", "Uid:\t77777\t77777\t77777\t77777\nGroups:\t4 " +
                                       std::to_string(info.st_gid) + " \n");
  EXPECT_EQ(check_ports(machine.root(), rig_with("/dev/ttyUSB0")).at(0).fitness, Fitness::ok);
}

TEST(Doctor, NobodyIsToldToJoinTheGroupOfRoot) {
  Machine machine;
  machine.plug_in();
  struct stat info {};
  ASSERT_EQ(::stat((machine.root() + "/dev/ttyUSB0").c_str(), &info), 0);
  machine.file("etc/group", "root:x:" + std::to_string(info.st_gid) + ":\n");
  machine.file("proc/self/status", "Uid:\t77777\t77777\t77777\t77777\nGroups:\t4 24 \n");
  const auto refused = check_ports(machine.root(), rig_with("/dev/ttyUSB0"));
  EXPECT_EQ(refused.at(0).fitness, Fitness::wrong);
  EXPECT_THAT(refused.at(0).command, testing::Not(HasSubstr("usermod")));
  EXPECT_THAT(refused.at(0).command, HasSubstr("sudo chgrp dialout /dev/ttyUSB0"));
}

TEST(Doctor, APortThatIsNotThereIsWrongOnlyForARigThatNamesIt) {
  const Machine machine;
  EXPECT_EQ(check_ports(machine.root(), rig_with("/dev/ttyUSB7")).at(0).fitness, Fitness::wrong);
  EXPECT_EQ(worst(check_ports(machine.root(), Needs{}))->fitness, Fitness::ok);
}

TEST(Doctor, AProgramThatHasThePortOpenIsNamed) {
  Machine machine;
  machine.plug_in();
  machine.file("proc/4711/comm", "gpsd\n");
  machine.link("proc/4711/fd/7", "/dev/ttyUSB0");
  const auto by_id = "/dev/serial/by-id/usb-FTDI_FT232R_A900-if00-port0";
  const auto found = check_holders(machine.root(), rig_with(by_id));
  EXPECT_EQ(found.at(0).fitness, Fitness::wrong);
  EXPECT_THAT(found.at(0).text, HasSubstr("gpsd (process 4711)"));
  EXPECT_EQ(found.at(0).command, "sudo systemctl stop gpsd.socket gpsd");
}

TEST(Doctor, ProgramsThatGrabNewAdaptersAreNamedWithTheCommandThatEndsIt) {
  Machine machine;
  machine.plug_in();
  machine.file("proc/10/comm", "ModemManager\n");
  machine.file("proc/11/comm", "brltty\n");
  const auto found = check_holders(machine.root(), rig_with("/dev/ttyUSB0"));
  ASSERT_EQ(found.size(), 2u);
  for (const auto& one : found) EXPECT_EQ(one.fitness, Fitness::advice);
  EXPECT_EQ(found[0].command, "sudo systemctl mask --now ModemManager");
  EXPECT_EQ(found[1].command, "sudo systemctl mask --now brltty.service brltty-udev.service");
}

TEST(Doctor, APortNamedByItsPlaceIsToldTheNameThatStays) {
  Machine machine;
  machine.plug_in();
  const std::string by_id = "/dev/serial/by-id/usb-FTDI_FT232R_A900-if00-port0";
  const auto found = check_names(machine.root(), rig_with("/dev/ttyUSB0"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].fitness, Fitness::advice);
  EXPECT_THAT(found[0].text, HasSubstr(by_id));
  EXPECT_TRUE(check_names(machine.root(), rig_with(by_id)).empty());
}

TEST(Doctor, TheAdviceToNameAPortByIdIsACommandThatWritesItIntoTheRigFile) {
  Machine machine;
  machine.plug_in();
  machine.file("it's a rig.toml",
               "link = \"serial:/dev/ttyUSB0?baud=9600\"  # not /dev/ttyUSB01\n");
  Needs needs = rig_with("/dev/ttyUSB0");
  needs.rig_file = machine.root() + "/it's a rig.toml";
  const auto found = check_names(machine.root(), needs);
  ASSERT_EQ(std::system(found.at(0).command.c_str()), 0) << found[0].command;
  std::string line;
  std::ifstream in(needs.rig_file);
  std::getline(in, line);
  EXPECT_EQ(line,
            "link = \"serial:/dev/serial/by-id/usb-FTDI_FT232R_A900-if00-port0?baud=9600\"  # not "
            "/dev/ttyUSB01");
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

TEST(Doctor, TheLatencyTimerOfAnFtdiChipIsSeen) {
  Machine machine;
  machine.plug_in();
  const auto found = check_latency(machine.root(), rig_with("/dev/ttyUSB0"));
  EXPECT_EQ(found.at(0).fitness, Fitness::advice);
  EXPECT_THAT(found.at(0).text, HasSubstr("16 ms"));
  EXPECT_EQ(found.at(0).command,
            "echo 1 | sudo tee /sys/bus/usb-serial/devices/ttyUSB0/latency_timer");
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

TEST(Doctor, ANetworkWithoutLoopbackCarriesNoDds) {
  Machine machine;
  EXPECT_EQ(check_network(machine.root(), Needs{}).at(0).fitness, Fitness::wrong);
  machine.file("sys/class/net/lo/flags", "0x8\n");
  EXPECT_EQ(check_network(machine.root(), Needs{}).at(0).command, "sudo ip link set lo up");
  machine.file("sys/class/net/lo/flags", "0x9\n");
  EXPECT_EQ(check_network(machine.root(), Needs{}).at(0).fitness, Fitness::advice);
  machine.file("sys/class/net/lo/flags", "0x1009\n");
  EXPECT_EQ(check_network(machine.root(), Needs{}).at(0).fitness, Fitness::ok);
}

TEST(Doctor, LimitsAndTheClockAreAdviceAtMost) {
  Machine machine;
  EXPECT_EQ(check_limits(machine.root()).at(0).fitness, Fitness::advice);
  EXPECT_EQ(check_clock(TIME_OK, 0).at(0).fitness, Fitness::ok);
  EXPECT_EQ(check_clock(TIME_ERROR, STA_UNSYNC).at(0).fitness, Fitness::advice);
}

TEST(Doctor, RealTimeNeedsThePriorityAndTheMemoryTogether) {
  Machine machine;
  const auto with = [&](const std::string& memory, const std::string& priority) {
    machine.file("proc/self/limits", "Max locked memory         " + memory + " " + memory +
                                         " bytes\n" + "Max realtime priority     " + priority +
                                         " " + priority + "\n");
    return check_limits(machine.root()).at(0);
  };
  EXPECT_EQ(with("unlimited", "99").fitness, Fitness::ok);
  EXPECT_EQ(with("unlimited", "10").fitness, Fitness::advice) << "--realtime takes 50";
  const auto locked = with("8388608", "50");
  EXPECT_EQ(locked.fitness, Fitness::advice);
  EXPECT_THAT(locked.text, HasSubstr("8388608 B of locked memory"));
  EXPECT_THAT(locked.command, HasSubstr("memlock unlimited"));
  EXPECT_THAT(locked.command, HasSubstr("rtprio 99"));
  machine.file("proc/self/status", "CapEff:\t000001ffffffffff\n");
  EXPECT_EQ(with("8388608", "0").fitness, Fitness::ok) << "root is not bound by limits";
}

TEST(Doctor, ARigNeedsWhatItsLinksName) {
  rig_config::Rig rig;
  for (const char* link : {"serial:/dev/ttyUSB0?baud=9600", "socketcan:can0", "socketcan:can0",
                           "slcan:/dev/ttyACM0", "pty:dvl", "can:auto"}) {
    rig.devices.emplace_back();
    rig.devices.back().link = link;
  }
  const Needs needs = needs_of(rig);
  EXPECT_THAT(needs.ports, testing::ElementsAre("/dev/ttyACM0", "/dev/ttyUSB0"));
  EXPECT_THAT(needs.buses, testing::ElementsAre("can0"));
  EXPECT_TRUE(needs.kernel_can);
  EXPECT_TRUE(needs.can_auto);
}

}  // namespace doctor_test
}  // namespace drydock::doctor
