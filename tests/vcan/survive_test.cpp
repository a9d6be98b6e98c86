// Events for drivers on an interface of the kernel: bus-off, an interface that goes down, a change
// of the clock.
#include <sys/time.h>

#include <fstream>

#include "drivers/link/can/can_interface.hpp"
#include "tests/hil/survive/bench.hpp"
#include "tests/vcan/process.hpp"

namespace drydock::fault::testing {
namespace vcan_survive_test {

class OnVcan : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto error = link::create_vcan(interface_);
    if (error == boost::system::errc::operation_not_permitted)
      GTEST_SKIP() << "making an interface needs CAP_NET_ADMIN";
    ASSERT_FALSE(error) << error.message();
  }
  void TearDown() override { vcan::run_program({"ip", "link", "delete", interface_}); }

  const std::string interface_ = "vsurvive" + std::to_string(::getpid() % 1000);
  const std::string link_ = "socketcan:" + interface_ + "?emulated=1";
};

TEST_F(OnVcan, BusOffReachesTheDriversAsAnErrorFrameOfTheKernelAndEnds) {
  expect_bus_off_told(link_);
}

TEST_F(OnVcan, AnInterfaceSetDownAndUpAgainStreamsWithoutHelpOnBothSides) {
  Bench bench(bus_depth(link_));
  ASSERT_TRUE(bench.reaches(State::streaming));
  ASSERT_FALSE(link::set_interface_up(interface_, false));
  ASSERT_TRUE(bench.reaches(State::backing_off));
  bench.pass(600ms);
  ASSERT_FALSE(link::set_interface_up(interface_, true));
  ASSERT_TRUE(bench.reaches(State::streaming));
  ASSERT_TRUE(bench.hears_again());
}

bool may_set_the_clock() {
  std::ifstream in("/proc/cpuinfo");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return text.find("User Mode Linux") != std::string::npos;
}

void step_the_clock(long seconds) {
  timeval now{};
  ::gettimeofday(&now, nullptr);
  now.tv_sec += seconds;
  ASSERT_EQ(::settimeofday(&now, nullptr), 0);
}

// It runs only in user-mode Linux, where nobody else uses the clock. Without a correction, an hour
// back would move every deadline an hour away, and an hour forward would end every wait at once.
TEST_F(OnVcan, AClockSetBackOrOnLeavesSilenceAndBackOffAsLongAsTheyAre) {
  if (!may_set_the_clock()) GTEST_SKIP() << "the clock of this machine is left alone";
  Bench bench(bus_depth(link_));
  ASSERT_TRUE(bench.reaches(State::streaming));
  for (const long step : {-3600L, 3600L}) {
    const auto lines = bench.lines.size();
    step_the_clock(step);
    ASSERT_TRUE(bench.hears_again()) << step;
    bench.pass(300ms);
    EXPECT_EQ(bench.lines.size(), lines) << bench.lines.back();
    bench.set(fault_of("depth", FaultKind::hang));
    bench.pass(100ms);
    step_the_clock(-step);
    ASSERT_TRUE(bench.reaches(State::stale)) << step;
    bench.clear();
    ASSERT_TRUE(bench.reaches(State::streaming)) << step;
    step_the_clock(step);
  }
}

}  // namespace vcan_survive_test
}  // namespace drydock::fault::testing
