// CAN adapters on USB, with the kernel's drivers gs_usb and usb_8dev: what a controller and its
// adapter can do that QEMU's own controllers cannot.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <thread>

#include "drivers/link/can/can_interface.hpp"
#include "tests/ports/can.hpp"
#include "tests/ports/driver.hpp"
#include "tests/ports/usb_device.hpp"

namespace drydock::ports {
namespace {

using device::State;
using fault::testing::Bench;
using namespace std::chrono_literals;

bool is_there(const std::string& name) { return link::find_can_interface(name).has_value(); }

bool says(const device::Health& health, std::string_view text) {
  return health.last_error.view().find(text) != std::string_view::npos;
}

/// True if `done` becomes true within 10 s of the machine's own time.
template <class Done>
bool eventually(Done&& done) {
  for (int i = 0; i < 500 && !done(); ++i) std::this_thread::sleep_for(20ms);
  return done();
}

/// One adapter for all of its tests: its program takes seconds to start under emulation.
class GsUsb : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { adapter_ = std::make_unique<UsbDevice>("usb_can.py gs_usb"); }
  static void TearDownTestSuite() { adapter_.reset(); }
  void SetUp() override {
    ASSERT_TRUE(eventually([] { return is_there("can2") && is_there("can3"); }));
    runs_on({"can2", "can3"});
    for (const char* name : {"can2", "can3"})
      bring_up(name, "bitrate 250000 dbitrate 1000000 fd on");
  }
  void TearDown() override {
    for (const char* name : {"can2", "can3"}) EXPECT_FALSE(link::set_interface_up(name, false));
  }
  static void order(const std::string& line) { adapter_->order(line); }

 private:
  static inline std::unique_ptr<UsbDevice> adapter_;
};

TEST_F(GsUsb, TheControllersStampsTakeOutTheTimeThatTheAdapterNeeds) {
  order("late 40");
  Bench bench(depth_on("can2"), depth_on("can3"));
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  ASSERT_TRUE(bench.until([&] { return bench.heard.size() >= 26; }));
  EXPECT_NE(bench.health().link_note.view().find("controller"), std::string_view::npos)
      << bench.health().link_note.view();
  // Every second frame of a 10 Hz sensor arrives 40 ms late: by arrival, one interval and the next
  // differ by 80 ms. The median leaves out what a busy machine delays.
  std::vector<double> differences_s;
  const auto interval_s = [&](std::size_t i) {
    const auto at = [&](std::size_t n) {
      return measurement::origin_of(bench.heard[n]).received_at;
    };
    return measurement::seconds(at(i + 1) - at(i));
  };
  for (std::size_t i = bench.heard.size() - 16; i + 2 < bench.heard.size(); ++i)
    differences_s.push_back(std::abs(interval_s(i + 1) - interval_s(i)));
  std::ranges::nth_element(differences_s, differences_s.begin() + 7);
  EXPECT_LT(differences_s[7], 0.04);
  order("late 0");
}

TEST_F(GsUsb, CanFdFramesOfOthersAreHeardWithoutHarm) {
  Bench bench(depth_on("can2"), depth_on("can3"));
  ASSERT_TRUE(bench.reaches(State::streaming));
  for (int i = 0; i < 10; ++i) order("fd 0");
  EXPECT_TRUE(bench.hears_again());
  EXPECT_EQ(bench.states.back(), State::streaming);
  EXPECT_EQ(bench.health().stream.bad_checksums, 0u);
  EXPECT_EQ(bench.health().error_frames, 0u);
}

TEST_F(GsUsb, AnErrorPassiveControllerAndABusThatIsOffAreNamed) {
  Bench bench(depth_on("can2"), depth_on("can3"));
  ASSERT_TRUE(bench.reaches(State::streaming));
  order("state 0 passive");
  ASSERT_TRUE(bench.until([&] { return says(bench.health(), "passive"); }))
      << bench.health().last_error.view();
  order("state 0 off");
  ASSERT_TRUE(bench.until([&] { return says(bench.health(), "bus-off"); }))
      << bench.health().last_error.view();
  EXPECT_EQ(link::find_can_interface("can2")->state, "BUS-OFF");
  order("state 0 restarted");
  EXPECT_TRUE(bench.hears_again());
  EXPECT_EQ(bench.health().error_frames, 3u);
}

TEST_F(GsUsb, AControllerThatLostFramesSaysSo) {
  Bench bench(depth_on("can2"), depth_on("can3"));
  ASSERT_TRUE(bench.reaches(State::streaming));
  order("state 0 overflow");
  ASSERT_TRUE(bench.until([&] { return says(bench.health(), "overflow"); }))
      << bench.health().last_error.view();
  EXPECT_TRUE(bench.hears_again());
}

TEST_F(GsUsb, AnAdapterPulledOutAndPutInAgainStreamsAsSoonAsItIsUp) {
  Bench bench(depth_on("can2"), depth_on("can3"));
  for (int time = 1; time <= 2; ++time) {
    ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
    order("unplug");
    ASSERT_TRUE(bench.until([] { return !is_there("can2"); }));
    ASSERT_TRUE(bench.reaches(State::backing_off));
    ASSERT_TRUE(bench.until([&] {
      return bench.lines.back().find("no CAN interface") != std::string::npos;
    })) << bench.lines.back();
    order("plug");
    ASSERT_TRUE(bench.until([] { return is_there("can2") && is_there("can3"); }));
    for (const char* name : {"can2", "can3"}) bring_up(name, "bitrate 250000");
    ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
    ASSERT_TRUE(bench.hears_again());
  }
}

TEST(Usb8dev, TheKernelRestartsAControllerThatWentBusOff) {
  UsbDevice adapter("usb_can.py usb_8dev");
  ASSERT_TRUE(eventually([] { return is_there("can2"); }));
  runs_on({"can2"});
  bring_up("can2", "bitrate 250000 restart-ms 100");
  Bench bench(depth_on("can2"), depth_on("can2"));
  ASSERT_TRUE(bench.reaches(State::streaming)) << bench.health().status.view();
  adapter.order("state 0 off");
  // A frame of the controller, and one of the kernel after restart-ms.
  ASSERT_TRUE(bench.until([&] { return bench.health().error_frames >= 2; }));
  EXPECT_TRUE(says(bench.health(), "bus-off") || says(bench.health(), "restarted"))
      << bench.health().last_error.view();
  adapter.order("state 0 active");
  EXPECT_TRUE(bench.hears_again());
}

}  // namespace
}  // namespace drydock::ports
