// The command `bridge`: what it refuses, and an emulated DVL's motion at an autopilot's port.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "drivers/wire/mavlink/mavlink.hpp"
#include "tests/hil/program/running.hpp"

namespace bridge_test {

using drydock::wire::Mavlink;
using drydock::wire::mavlink::Heartbeat;
using drydock::wire::mavlink::VisionPositionDelta;
using program::drydock;
using program::Folder;
using program::Running;
using testing::HasSubstr;

#define DEMO "rig_config/rigs/demo.toml"

/// A UDP port of this machine at which an autopilot would be. It says who it is to whoever speaks.
class AutopilotPort {
 public:
  AutopilotPort() : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof own;
    auto* address = reinterpret_cast<sockaddr*>(&own);
    ::bind(socket_, address, size);
    ::getsockname(socket_, address, &size);
    port_ = ntohs(own.sin_port);
  }
  ~AutopilotPort() { ::close(socket_); }
  AutopilotPort(const AutopilotPort&) = delete;
  AutopilotPort& operator=(const AutopilotPort&) = delete;

  std::string uri() const { return "udp:127.0.0.1:" + std::to_string(port_); }

  /// Waits for this many deltas, but not longer than patience lasts.
  std::vector<VisionPositionDelta> deltas(std::size_t wanted) {
    std::vector<VisionPositionDelta> found;
    const auto end = std::chrono::steady_clock::now() + program::patience;
    while (found.size() < wanted && std::chrono::steady_clock::now() < end)
      if (const auto message = receive())
        if (const auto* delta = std::get_if<VisionPositionDelta>(&*message))
          found.push_back(*delta);
    return found;
  }

 private:
  std::optional<Mavlink::Message> receive() {
    pollfd wait{socket_, POLLIN, 0};
    if (::poll(&wait, 1, 100) != 1) return {};
    std::array<std::uint8_t, 1500> bytes;
    sockaddr_in from{};
    socklen_t size = sizeof from;
    auto* address = reinterpret_cast<sockaddr*>(&from);
    const auto n = ::recvfrom(socket_, bytes.data(), bytes.size(), 0, address, &size);
    if (n <= 0) return {};
    Heartbeat own;
    own.sender = {1, 1, 0};
    own.autopilot = 3;  // MAV_AUTOPILOT_ARDUPILOTMEGA
    std::array<std::uint8_t, Mavlink::max_frame> frame;
    ::sendto(socket_, frame.data(), drydock::wire::mavlink::encode(own, frame), 0, address, size);
    const auto got = std::span(bytes).first(static_cast<std::size_t>(n));
    if (Mavlink::scan(got) != drydock::wire::Scan::frame(got.size())) return {};
    return Mavlink::decode(got);
  }

  int socket_;
  std::uint16_t port_ = 0;
};

TEST(Program, ABridgeRefusesWhatCannotBeAndSaysWhatCan) {
  const auto no_dvl = drydock("bridge mavlink " DEMO " --to udp:127.0.0.1:1 --device imu");
  EXPECT_EQ(no_dvl.exit_code, 2);
  EXPECT_THAT(no_dvl.output, HasSubstr("it has to be one; DVLs: dvl"));
  const auto bus = drydock("bridge mavlink " DEMO " --to socketcan:can0");
  EXPECT_EQ(bus.exit_code, 2);
  EXPECT_THAT(bus.output, HasSubstr("allowed: udp tcp serial pty"));
  const auto slow = drydock("bridge mavlink " DEMO " --to 'serial:/dev/null?baud=1200'");
  EXPECT_EQ(slow.exit_code, 2);
  // 120 bytes a second. 5 pings of 56 bytes and a heartbeat of 21 are 301.
  EXPECT_THAT(slow.output, HasSubstr("carries 120 bytes a second, the messages need 301"));
}

TEST(Program, ABridgeWithoutADvlSendsNothingAndEndsWithOne) {
  const auto run =
      drydock("bridge mavlink pty:nobody --protocol pd0 --to udp:127.0.0.1:9 --for 1s");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("0 pings: 0 sent"));
}

// The demo's mission begins with 3 m/s; its DVL pings five times a second.
TEST(Program, ABridgeBringsAnEmulatedDvlsMotionToAnAutopilot) {
  const Folder folder;
  AutopilotPort autopilot;
  const Running emulated(folder, "emulate " DEMO, "emulate.txt");
  ASSERT_TRUE(emulated.says("dvl"));
  Running bridge(folder, "bridge mavlink " DEMO " --json --to " + autopilot.uri(), "bridge.txt");
  const auto deltas = autopilot.deltas(10);
  ASSERT_EQ(deltas.size(), 10U) << bridge.output();
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    const auto& delta = deltas[i];
    EXPECT_EQ(delta.sender.system, 1);
    EXPECT_EQ(delta.sender.component, 197);
    const double seconds = std::chrono::duration<double>(delta.time_delta).count();
    EXPECT_NEAR(delta.position_m[0] / seconds, 3, 1);
    if (i == 0) continue;
    const auto between = delta.time - deltas[i - 1].time;
    EXPECT_NEAR(static_cast<double>((between - delta.time_delta).count()), 0, 1)
        << "the intervals join, each rounded to a microsecond";
  }
  EXPECT_TRUE(bridge.says("the autopilot answers"));
  EXPECT_EQ(bridge.end(SIGTERM), 0) << "nobody told it an end";
  const auto output = bridge.output();
  const auto figures = nlohmann::json::parse(output.substr(output.find('{')));
  EXPECT_GE(figures["sent"], 10);
  EXPECT_LT(figures["without_rotation"], figures["sent"]) << "the rig has an IMU";
  EXPECT_LT(figures["oldest_ms"], 200);
  EXPECT_GE(figures["autopilot_heartbeats"], 10);
}

}  // namespace bridge_test
