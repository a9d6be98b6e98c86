// The commands that `drydock doctor`, a refused link and the pages advise are run, and mend what
// they are for.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/ports/usb_device.hpp"
#include "tests/vcan/process.hpp"

namespace drydock::ports {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

constexpr const char* by_id = "/dev/serial/by-id/usb-QEMU_USB_SERIAL_A-if00-port0";

/// The machine has no sudo, and its user is root. The program is installed.
int run_as_root(std::string command) {
  for (auto at = command.find("sudo "); at != command.npos; at = command.find("sudo "))
    command.erase(at, 5);
  return vcan::run_program({"sh", "-c", "PATH=$PATH:$(dirname " DRYDOCK_PROGRAM "); " + command});
}

/// `output` of the command on standard output and errors.
std::string said_by(const std::string& command) {
  vcan::Process shell({"sh", "-c", command});
  shell.wait();
  return shell.output_until("\n\n");
}

/// A CAN adapter whose interfaces are there: can2 and, for gs_usb, can3.
struct Adapter : UsbDevice {
  explicit Adapter(const std::string& driver) : UsbDevice("usb_can.py " + driver) {
    for (int i = 0; i < 500 && !std::filesystem::exists("/sys/class/net/can2"); ++i)
      std::this_thread::sleep_for(20ms);
  }
};

/// A rig with these links, on disk.
std::string rig_with(const std::vector<std::string>& links) {
  const std::string path = ::testing::TempDir() + "doctored.toml";
  std::ofstream out(path);
  out << "[rig]\nname = \"doctored\"\n";
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool is_line = links[i].starts_with("serial");
    out << "\n[[device]]\nname = \"d" << i << "\"\nkind = \"" << (is_line ? "emlog" : "depth")
        << "\"\nprotocol = \"" << (is_line ? "nmea0183" : "nmea2000") << "\"\nlink = \"" << links[i]
        << "\"\nrate_hz = 1\n";
  }
  return path;
}

/// What is not ok and has a command; `as`: what to put before the program.
std::vector<json> found_by_doctor(const std::string& rig, const std::string& as = {},
                                  const std::string& program = DRYDOCK_PROGRAM) {
  const auto report = json::parse(
      said_by(as + " " + program + " doctor " + rig + " --json" + (as.empty() ? "" : "'")));
  std::vector<json> found;
  for (const auto& check : report.at("checks"))
    if (check.at("fitness") != "ok") found.push_back(check);
  return found;
}

bool tells(const std::vector<json>& found, const std::string& text) {
  for (const auto& one : found)
    if (one.at("text").get<std::string>().find(text) != std::string::npos) return true;
  return false;
}

/// The clock needs a service manager, and the disk another machine.
bool is_of_this_machine(const json& one) {
  return one.at("check") != "clock" && one.at("check") != "disk";
}

void take_all_advice(const std::vector<json>& found) {
  for (const auto& one : found) {
    if (!is_of_this_machine(one)) continue;
    EXPECT_EQ(run_as_root(one.at("command")), 0) << one.dump();
  }
}

bool is_active(const std::string& name) {
  return said_by("ip -details link show " + name).find("state ERROR-ACTIVE") != std::string::npos;
}

/// The command of a link with listen=1, as the pages have it too.
void set_listen_only(const std::string& name) {
  const std::string set = "ip link set " + name;
  EXPECT_EQ(run_as_root(set + " down; " + set + " up type can listen-only on"), 0) << name;
  EXPECT_NE(said_by("ip -details link show " + name).find("LISTEN-ONLY"), std::string::npos);
}

TEST(Doctor, ItsCommandsMendModulesInterfacesNamesAndTimers) {
  Adapter adapter("gs_usb");
  ASSERT_EQ(run_as_root("ip link set can2 up type can bitrate 250000; "
                        "ip link set can3 up type can bitrate 500000; "
                        "modprobe -r kvaser_pci ftdi_sio; ip link set lo down"),
            0);
  adapter.order("state 0 off");
  std::filesystem::create_directories("/dev/serial/by-id");
  std::filesystem::remove(by_id);
  std::filesystem::create_symlink("../../ttyUSB0", by_id);
  const std::string rig =
      rig_with({"socketcan:can0?bitrate=500000", "socketcan:can1", "socketcan:can2",
                "socketcan:can3?bitrate=250000", "serial:/dev/ttyUSB0?baud=4800"});

  const auto first = found_by_doctor(rig);
  EXPECT_TRUE(tells(first, "ftdi_sio is not loaded"));
  EXPECT_TRUE(tells(first, "kvaser_pci is not loaded"));
  EXPECT_TRUE(tells(first, "there is no CAN interface can0"));
  EXPECT_TRUE(tells(first, "/dev/ttyUSB0 is not there"));
  EXPECT_TRUE(tells(first, "can2 is bus-off"));
  EXPECT_TRUE(tells(first, "can3 runs at 500000 bit/s, the rig says 250000"));
  EXPECT_TRUE(tells(first, "the loopback interface is down"));
  take_all_advice(first);
  EXPECT_TRUE(is_active("can2"));

  ASSERT_EQ(run_as_root("echo 16 > /sys/bus/usb-serial/devices/ttyUSB0/latency_timer"), 0);
  const auto second = found_by_doctor(rig);
  EXPECT_TRUE(tells(second, "can0 is down"));
  EXPECT_TRUE(tells(second, "can0 queues 10 frames"));
  EXPECT_TRUE(tells(second, "keeps bytes for up to 16 ms"));
  EXPECT_TRUE(tells(second, by_id));
  take_all_advice(second);

  EXPECT_EQ(run_as_root("test $(cat /sys/bus/usb-serial/devices/ttyUSB0/latency_timer) = 1 && "
                        "test $(cat /sys/class/net/can0/tx_queue_len) = 1000 && "
                        "ip link show lo | grep -q LOOPBACK,MULTICAST,UP && "
                        "grep -q 'serial:/dev/serial/by-id/.*baud=4800' " +
                        rig),
            0);
  for (const char* name : {"can0", "can1", "can2", "can3"}) EXPECT_TRUE(is_active(name)) << name;
  set_listen_only("can2");
  EXPECT_EQ(run_as_root("ip link set can2 down; ip link set can2 up type can bitrate 250000 "
                        "dbitrate 2000000 fd on"),
            0);
  run_as_root("ip link set can0 down; ip link set can1 down");
}

TEST(Doctor, AUsb8devIsSetUpAndBroughtBackFromBusOff) {
  Adapter adapter("usb_8dev");
  const std::string rig = rig_with({"socketcan:can2"});
  take_all_advice(found_by_doctor(rig));
  EXPECT_TRUE(is_active("can2"));
  adapter.order("state 0 off");
  for (int i = 0; i < 100 && is_active("can2"); ++i) std::this_thread::sleep_for(20ms);
  // restart-ms would bring it back by itself, were the adapter not off again at once.
  EXPECT_EQ(run_as_root("ip link set can2 down; ip link set can2 up"), 0);
  EXPECT_TRUE(is_active("can2"));
  set_listen_only("can2");
}

/// The part of a line after the last ": " that precedes the command.
std::string command_in(const std::string& text, const std::string& after) {
  const auto begin = text.find(after);
  if (begin == text.npos) return "echo no command in: '" + text + "'; false";
  const auto from = begin + after.size();
  return text.substr(from, text.find_first_of("\n,", from) - from);
}

TEST(Links, TheCommandsOfARefusedOrActiveInterfaceWork) {
  run_as_root("ip link set can0 down; ip link set can1 down");
  const std::string monitor = DRYDOCK_PROGRAM " monitor 'socketcan:can0?";
  const std::string end = "' --protocol nmea2000 --for 0.2s";
  EXPECT_EQ(run_as_root(command_in(said_by(monitor + "bitrate=125000" + end), "is down: ")), 0);
  EXPECT_TRUE(is_active("can0"));
  EXPECT_EQ(run_as_root(command_in(said_by(monitor + "listen=1" + end), "acknowledges: ")), 0);
  const auto shown = said_by("ip -details link show can0");
  EXPECT_NE(shown.find("LISTEN-ONLY"), shown.npos) << shown;
  EXPECT_NE(shown.find("bitrate 125000"), shown.npos) << shown;
  run_as_root("ip link set can0 down; ip link set can0 type can listen-only off");
}

/// A user of the machine who may nothing yet: what they are told, they type, and log in again.
TEST(Doctor, AUserGetsThePortAndRealTimeByTheAdvisedCommands) {
  const std::string user = "su nobody -s /bin/sh -c '",
                    rig = rig_with({"serial:/dev/ttyS1?baud=4800"});
  // The tree may lie where no other user may look, as under /root.
  const std::string program = ::testing::TempDir() + "drydock";
  ASSERT_EQ(run_as_root("cp " DRYDOCK_PROGRAM " " + program + " && chmod 755 " + program), 0);
  run_as_root("chmod a+r " + rig +
              "; rm -f /etc/security/limits.d/drydock.conf; chown root:root "
              "/dev/ttyS1; chmod 600 /dev/ttyS1");
  const pid_t holder = ::fork();
  if (holder == 0) {  // a program of the same user
    constexpr unsigned nobody = 65534;
    const int port = ::open("/dev/ttyS1", O_RDWR | O_NONBLOCK | O_NOCTTY);
    if (port < 0 || ::setresgid(nobody, nobody, nobody) != 0 ||
        ::setresuid(nobody, nobody, nobody) != 0)
      ::_exit(1);
    ::prctl(PR_SET_DUMPABLE, 1);  // its files can be seen, as those of a program that it started
    for (;;) ::pause();
  }
  ::setenv("USER", "nobody", 1);
  const auto first = found_by_doctor(rig, user, program);
  EXPECT_TRUE(tells(first, "/dev/ttyS1 is for root alone"));
  EXPECT_TRUE(tells(first, "--realtime is refused"));
  EXPECT_TRUE(tells(first, "has /dev/ttyS1 open"));
  take_all_advice(first);
  int status = 0;
  ::kill(holder, SIGKILL);  // only if the advised SIGTERM did not end it
  ASSERT_EQ(::waitpid(holder, &status, 0), holder);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;

  const auto second = found_by_doctor(rig, user, program);
  EXPECT_TRUE(tells(second, "/dev/ttyS1 belongs to the group dialout, and you do not"));
  take_all_advice(second);
  const auto driven = said_by(user + program + " drive " + rig + " --realtime --for 0.1s'");
  EXPECT_EQ(driven.find("refuses"), driven.npos) << driven;
  EXPECT_EQ(driven.find("cannot open"), driven.npos) << driven;
  EXPECT_NE(driven.find("real time: SCHED_FIFO"), driven.npos) << driven;
}

}  // namespace
}  // namespace drydock::ports
