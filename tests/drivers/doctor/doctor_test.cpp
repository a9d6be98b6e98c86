#include <gmock/gmock.h>
#include <sys/timex.h>

#include "tests/drivers/doctor/machine.hpp"

/// The machine as a whole, and what a rig needs of it.
namespace drydock::doctor {
namespace doctor_test {

using testing::HasSubstr;

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
