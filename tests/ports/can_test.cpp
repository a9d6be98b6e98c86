// Drivers and emulated devices on two SJA1000 controllers (kvaser_pci) of one bus.
#include <gtest/gtest.h>

#include "drivers/link/can/can_interface.hpp"
#include "tests/ports/can.hpp"
#include "tests/ports/driver.hpp"

namespace drydock::ports {
namespace {

using device::State;
using fault::testing::Bench;
using namespace std::chrono_literals;
using vcan::run_program;

class Sja1000 : public ::testing::Test {
 protected:
  void SetUp() override {
    runs_on({"can0", "can1"});
    bring_up("can0", "bitrate 250000 restart-ms 100 berr-reporting on");
    bring_up("can1", "bitrate 250000");
  }
  void TearDown() override {
    for (const char* name : {"can0", "can1"}) EXPECT_FALSE(link::set_interface_up(name, false));
  }
};

TEST_F(Sja1000, SensorsOfOneControllerReachTheDriversOfTheOther) {
  Bench bench(depth_on("can0"), depth_on("can1"));
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  ASSERT_TRUE(bench.until([&] { return bench.messages >= 20; }));
  EXPECT_EQ(bench.health().can_dropped, 0u);
  EXPECT_EQ(bench.health().error_frames, 0u);
  EXPECT_EQ(bench.health().stream.bad_checksums, 0u);
}

TEST_F(Sja1000, TheKernelTellsTheRateAndTheStateOfTheController) {
  const auto found = link::find_can_interface("can0");
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->up);
  EXPECT_FALSE(found->is_vcan);
  EXPECT_EQ(found->bitrate, 250000u);
  EXPECT_EQ(found->state, "ERROR-ACTIVE");
}

TEST_F(Sja1000, AnInterfaceSetDownAndUpAgainStreamsWithoutHelp) {
  Bench bench(depth_on("can0"), depth_on("can1"));
  ASSERT_TRUE(bench.reaches(State::streaming));
  ASSERT_FALSE(link::set_interface_up("can0", false));
  ASSERT_TRUE(bench.reaches(State::backing_off));
  ASSERT_FALSE(link::set_interface_up("can0", true));
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  EXPECT_TRUE(bench.hears_again());
}

TEST_F(Sja1000, AListenOnlyControllerStillHearsTheSensors) {
  ASSERT_FALSE(link::set_interface_up("can0", false));
  bring_up("can0", "bitrate 250000 listen-only on");
  Bench bench(depth_on("can0"), depth_on("can1"));
  EXPECT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  EXPECT_TRUE(bench.hears_again());
  ASSERT_FALSE(link::set_interface_up("can0", false));
  run_program({"ip", "link", "set", "can0", "type", "can", "listen-only", "off"});
}

TEST_F(Sja1000, ABusThatIsFloodedBesideTheSensorLosesNoneOfItsMessages) {
  Bench bench(depth_on("can0"), depth_on("can1"));
  ASSERT_TRUE(bench.reaches(State::streaming));
  vcan::Process flood(
      {"cangen", "can1", "-g", "1", "-I", "7FF", "-L", "8", "-D", "i", "-n", "700"});
  ASSERT_EQ(flood.wait(), 0);
  EXPECT_TRUE(bench.hears_again());
  EXPECT_EQ(bench.health().can_dropped, 0u);
  EXPECT_EQ(bench.states.back(), State::streaming);
}

}  // namespace
}  // namespace drydock::ports
