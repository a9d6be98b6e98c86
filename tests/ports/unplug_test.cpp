// A USB serial adapter that is pulled out under load and put in again.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "tests/hil/survive/bench.hpp"
#include "tests/ports/driver.hpp"
#include "tests/ports/machine.hpp"
#include "tests/vcan/process.hpp"

namespace drydock::ports {
namespace {

using device::State;
using fault::testing::Bench;
using fault::testing::speed_log;
using namespace std::chrono_literals;

rig_config::DeviceConfig log_on(const std::string& port) {
  return speed_log("serial:" + port + "?emulated=1&baud=38400");
}

class Adapter : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(adapters_are_there());
    runs_on({"/dev/ttyUSB0", "/dev/ttyUSB1"});
  }
};

/// Pulls out the driver's adapter and puts it in again.
void comes_back_within_two_seconds(Bench& bench, int times) {
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  for (int time = 1; time <= times; ++time) {
    EXPECT_EQ(unplug("usb0").find("error"), std::string::npos);
    ASSERT_TRUE(bench.reaches(State::backing_off)) << bench.health().status.view();
    // The machine frees the adapter's place about 50 ms after it was pulled out.
    bench.pass(200ms);
    EXPECT_EQ(plug("usb0").find("error"), std::string::npos);
    ASSERT_TRUE(bench.until([] { return adapters_are_there(); }));
    const auto back = link::steady_now();
    ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
    ASSERT_TRUE(bench.hears_again());
    EXPECT_LT(link::steady_now() - back, 2s) << "time " << time;
  }
  EXPECT_EQ(bench.health().stream.bad_checksums, 0u);
}

TEST_F(Adapter, PulledOutAndPutInAgainStreamsWithinTwoSecondsOfItsReturn) {
  Bench bench(log_on("/dev/ttyUSB0"), log_on("/dev/ttyUSB1"));
  comes_back_within_two_seconds(bench, 3);
}

/// The driver gives a CAN adapter that comes back all its commands again.
TEST_F(Adapter, ThatLeadsToABusPulledOutAndPutInAgainStreamsToo) {
  const auto depth_on = [](const std::string& port) {
    return fault::testing::bus_depth("slcan:" + port + "?emulated=1&bitrate=250000");
  };
  Bench bench(depth_on("/dev/ttyUSB0"), depth_on("/dev/ttyUSB1"));
  comes_back_within_two_seconds(bench, 2);
}

TEST_F(Adapter, TheLinesBytesAreAccountedForAfterTheAdapterWent) {
  Bench bench(log_on("/dev/ttyUSB0"), log_on("/dev/ttyUSB1"));
  ASSERT_TRUE(bench.hears_again());
  unplug("usb0");
  ASSERT_TRUE(bench.reaches(State::backing_off));
  const auto health = bench.health();
  EXPECT_EQ(health.stream.bytes_in,
            health.stream.bytes_good + health.stream.bytes_skipped + health.held_bytes);
  bench.pass(200ms);
  plug("usb0");
  ASSERT_TRUE(bench.until([] { return adapters_are_there(); }));
}

TEST(Held, APortThatAnotherProgramHasLockedIsRefusedInALineThatSaysSo) {
  runs_on({"/dev/ttyS1", "/dev/ttyS2"});
  const int other = ::open("/dev/ttyS1", O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(other, 0);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  Bench bench(log_on("/dev/ttyS1"), log_on("/dev/ttyS2"));
  ASSERT_TRUE(bench.reaches(State::backing_off));
  EXPECT_EQ(bench.lines.back().find("cannot open /dev/ttyS1: "), 0u) << bench.lines.back();
  EXPECT_NE(bench.lines.back().find("another program has it open"), std::string::npos);
  ::close(other);
  EXPECT_TRUE(bench.reaches(State::streaming)) << "the port is free again";
}

TEST(Held, APortThatThisUserMayNotOpenIsRefusedInALineThatNamesTheGroup) {
  runs_on({"/dev/ttyS1", "/dev/ttyS2"});
  constexpr uid_t nobody = 65534;
  ASSERT_EQ(::chmod("/dev/ttyS2", 0666), 0);  // the emulated sensor's end
  ASSERT_EQ(::seteuid(nobody), 0);
  Bench bench(log_on("/dev/ttyS1"), log_on("/dev/ttyS2"));
  const bool refused = bench.reaches(State::backing_off);
  ASSERT_EQ(::seteuid(0), 0);
  ASSERT_TRUE(refused);
  EXPECT_EQ(bench.lines.back().find("cannot open /dev/ttyS1: Permission denied"), 0u)
      << bench.lines.back();
  EXPECT_NE(bench.lines.back().find("dialout"), std::string::npos) << bench.lines.back();
  EXPECT_TRUE(bench.reaches(State::streaming)) << "this user may open it now";
}

/// udev's name of an adapter; it holds the adapter's serial number.
std::string lasting_name(const char* number) {
  return std::string("/dev/serial/by-id/usb-QEMU_QEMU_USB_SERIAL_") + number + "-if00-port0";
}

bool names_are_there() {
  return std::filesystem::exists(lasting_name("A")) && std::filesystem::exists(lasting_name("B"));
}

/// udev, and its names, as long as the object lives: programs that run later find none.
struct Udev {
  Udev() { EXPECT_EQ(vcan::run_program({"/usr/lib/systemd/systemd-udevd", "--daemon"}), 0); }
  Udev(const Udev&) = delete;
  Udev& operator=(const Udev&) = delete;
  ~Udev() {
    EXPECT_EQ(vcan::run_program({"udevadm", "control", "--exit"}), 0);
    std::filesystem::remove_all("/dev/serial");
  }
};

TEST_F(Adapter, ALastingNameFollowsTheAdapterWhenTheKernelsNamesChangePlaces) {
  const Udev udev;
  ASSERT_EQ(vcan::run_program({"udevadm", "trigger", "--action=add", "--subsystem-match=usb",
                               "--subsystem-match=usb-serial", "--subsystem-match=tty"}),
            0);
  ASSERT_EQ(vcan::run_program({"udevadm", "settle"}), 0);
  ASSERT_TRUE(names_are_there());
  const auto first = std::filesystem::canonical(lasting_name("A"));

  Bench bench(log_on(lasting_name("A")), log_on(lasting_name("B")));
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  for (const char* adapter : {"usb0", "usb1"}) unplug(adapter);
  ASSERT_TRUE(bench.reaches(State::backing_off));
  bench.pass(200ms);
  for (const char* adapter : {"usb1", "usb0"}) {
    plug(adapter);
    bench.pass(700ms);
  }
  ASSERT_TRUE(bench.until([] { return names_are_there(); }));
  EXPECT_NE(std::filesystem::canonical(lasting_name("A")), first) << "the kernel's name";
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  EXPECT_TRUE(bench.hears_again());
}

}  // namespace
}  // namespace drydock::ports
