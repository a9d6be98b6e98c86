// Real-time scheduling on a kernel that grants it.
#include "drivers/io/scheduling.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <fstream>
#include <string>
#include <thread>

namespace drydock::ports {
namespace {

/// Locked memory of this process, KiB (proc(5), VmLck).
long locked_kib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmLck:")) return std::stol(line.substr(6));
  return -1;
}

TEST(Scheduling, TheLoopIsFifoAndLockedAndThreadsThatItStartsAreNot) {
  ASSERT_EQ(::sched_getscheduler(0), SCHED_OTHER);
  const auto done = io::claim({.priority = 42, .cores = {0}});
  ASSERT_TRUE(done) << done.error().message;
  sched_param parameters{};
  ASSERT_EQ(::sched_getparam(0, &parameters), 0);
  EXPECT_EQ(::sched_getscheduler(0) & ~SCHED_RESET_ON_FORK, SCHED_FIFO);
  EXPECT_EQ(parameters.sched_priority, 42);
  EXPECT_GT(locked_kib(), 0);
  int other = -1;
  std::thread([&] { other = ::sched_getscheduler(0); }).join();
  EXPECT_EQ(other & ~SCHED_RESET_ON_FORK, SCHED_OTHER);

  const sched_param normal{};
  ASSERT_EQ(::sched_setscheduler(0, SCHED_OTHER, &normal), 0);
}

}  // namespace
}  // namespace drydock::ports
