// The demo rig with --realtime on a kernel that grants it.
#include <gtest/gtest.h>

#include "tests/vcan/process.hpp"

namespace drydock::ports {
namespace {

TEST(RealTimeRun, TheDemoRigStreamsInFifoWithItsMemoryLocked) {
  vcan::Process run({DRYDOCK_PROGRAM, "run", DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml",
                     "--for", "3s", "--realtime"});
  const auto said = run.output_until("expectations met");
  EXPECT_NE(said.find("real time: SCHED_FIFO at priority 50, memory locked"), said.npos) << said;
  for (const char* device : {"dvl", "emlog", "gnss", "imu", "depth"})
    EXPECT_NE(said.find(std::string(device) + ": waiting -> streaming"), said.npos) << said;
}

}  // namespace
}  // namespace drydock::ports
