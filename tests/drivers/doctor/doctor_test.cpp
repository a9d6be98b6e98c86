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
  EXPECT_THAT(found[0].text, HasSubstr("serial:" + by_id));
  EXPECT_TRUE(check_names(machine.root(), rig_with(by_id)).empty());
}

TEST(Doctor, AShortSendQueueOfACanInterfaceIsLengthened) {
  Machine machine;
  machine.file("sys/class/net/can0/type", "280\n");
  machine.file("sys/class/net/can0/tx_queue_len", "10\n");
  Needs needs{
      .whole_machine = false, .ports = {}, .buses = {"can0"}, .bitrates = {}, .kernel_can = true};
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
  machine.file("proc/self/limits", "Max realtime priority     50                   50\n");
  EXPECT_EQ(check_limits(machine.root()).at(0).fitness, Fitness::ok);
  EXPECT_EQ(check_clock(TIME_OK, 0).at(0).fitness, Fitness::ok);
  EXPECT_EQ(check_clock(TIME_ERROR, STA_UNSYNC).at(0).fitness, Fitness::advice);
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
