#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

#include "drivers/doctor/ports.hpp"
#include "tests/drivers/doctor/machine.hpp"

/// Serial ports: their names, who may open them and who has them open.
namespace drydock::doctor {
namespace serial_ports_test {

using testing::HasSubstr;

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
  const auto of_none = check_ports(machine.root(), Needs{});
  ASSERT_FALSE(of_none.empty());
  for (const auto& one : of_none) EXPECT_EQ(one.fitness, Fitness::ok);
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

TEST(Doctor, TheLatencyTimerOfAnFtdiChipIsSeen) {
  Machine machine;
  machine.plug_in();
  const auto found = check_latency(machine.root(), rig_with("/dev/ttyUSB0"));
  EXPECT_EQ(found.at(0).fitness, Fitness::advice);
  EXPECT_THAT(found.at(0).text, HasSubstr("16 ms"));
  EXPECT_EQ(found.at(0).command,
            "echo 1 | sudo tee /sys/bus/usb-serial/devices/ttyUSB0/latency_timer");
}

}  // namespace serial_ports_test
}  // namespace drydock::doctor
