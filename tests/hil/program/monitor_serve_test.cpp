#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "tests/hil/program/running.hpp"
#include "tests/npm/node.hpp"

/// The monitor serves to browsers what it receives. Foxglove's own client checks this.
namespace monitor_serve_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;
using namespace std::chrono_literals;

/// `monitor` beside an emulated demo, and what a client at its address receives.
class ServedMonitor {
 public:
  explicit ServedMonitor(const std::string& arguments)
      : run_([this, arguments] {
          outcome_ = drydock(
              "emulate rig_config/rigs/demo.toml --for 60s > /dev/null & e=$!; sleep "
              "1; " DRYDOCK_PROGRAM " monitor " +
              arguments + " --for 6s > /dev/null 2> " + (folder_ / "live").string() +
              "; r=$?; kill -INT $e; wait; exit $r");
        }) {}

  /// "ws://127.0.0.1:PORT/..." as soon as it is served. The monitor of a link probes first.
  std::string address() const {
    for (int i = 0; i < 300; ++i) {
      const auto said = program::read_file(folder_ / "live");
      const auto from = said.find("live: http"), to = said.find('\n', from);
      if (from != std::string::npos && to != std::string::npos)
        return "ws" + said.substr(from + 10, to - from - 10);
      std::this_thread::sleep_for(50ms);
    }
    return {};
  }
  nlohmann::json watch(const std::string& address) const {
    return drydock::test::run_node("tests/drivers/live/watch.cjs",
                                   {address, "20", "", "/dvl/bottom_track", "/diagnostics"});
  }
  int exit_code() {
    run_.join();
    return outcome_.exit_code;
  }

 private:
  Folder folder_;
  program::Outcome outcome_;
  std::jthread run_;
};

TEST(MonitorServe, ARigsDevicesAndHealthAreOnTheFoxgloveSocket) {
  DRYDOCK_NEEDS_NODE();
  ServedMonitor monitor("rig_config/rigs/demo.toml --serve 0");
  const auto seen = monitor.watch(monitor.address());
  EXPECT_EQ(seen["server"], "drydock demo");
  EXPECT_TRUE(seen["channels"].contains("/dvl/bottom_track"));
  // The IMU is silent: a monitor only listens, and no program starts the node.
  ASSERT_TRUE(seen["messages"].contains("/dvl/bottom_track")) << seen;
  EXPECT_EQ(seen["messages"]["/dvl/bottom_track"]["value"]["header"]["frame_id"], "dvl_link_frd");
  EXPECT_TRUE(seen["messages"].contains("/diagnostics"));
  monitor.exit_code();
}

TEST(MonitorServe, ALinksSensorsAreThereUnderTheNamesThatProbingGives) {
  DRYDOCK_NEEDS_NODE();
  ServedMonitor monitor("pty:dvl --serve 0 --token mine");
  const auto address = monitor.address();
  ASSERT_THAT(address, HasSubstr("?token=mine"));
  const auto refused = monitor.watch(address.substr(0, address.find('?')));
  EXPECT_THAT(refused["error"].dump(), HasSubstr("403"));
  const auto seen = monitor.watch(address);
  EXPECT_EQ(seen["server"], "drydock pty:dvl");
  EXPECT_TRUE(seen["messages"].contains("/dvl/bottom_track")) << seen;
  EXPECT_EQ(monitor.exit_code(), 0);
}

/// What the page asks for when it is opened.
std::string history_at(const std::string& port) {
  const Folder folder;
  const auto file = (folder / "history").string();
  const auto ask = "bash -c 'exec 3<>/dev/tcp/127.0.0.1/" + port +
                   R"(; printf "GET /history HTTP/1.0\r\nHost: 127.0.0.1\r\n\r\n" >&3; )"
                   "cat <&3' > " +
                   file;
  return std::system(ask.c_str()) == 0 ? program::read_file(file) : "";
}

TEST(RunServe, TellsViewersWhatTheEstimatorPromises) {
  const Folder folder;
  const program::Running bench(folder, "run rig_config/rigs/demo.toml --serve 0", "run.txt");
  const auto url = bench.line_from("live: http://127.0.0.1:");
  std::string past;
  const auto end = std::chrono::steady_clock::now() + program::patience;
  while (past.find("leveling/integrity") == std::string::npos &&
         std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(200ms);
    past = history_at(url.substr(0, url.find('/')));
  }
  EXPECT_THAT(past, HasSubstr("leveling/integrity"));
  EXPECT_THAT(past, HasSubstr("roll_bound_deg"));
}

TEST(MonitorServe, OneTableOrOneProtocolIsNothingToServe) {
  for (const char* other : {"--once", "--protocol pd6"}) {
    const auto outcome = drydock(std::string("monitor pty:dvl --serve 0 ") + other);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.output, HasSubstr("excludes"));
  }
}

}  // namespace monitor_serve_test
