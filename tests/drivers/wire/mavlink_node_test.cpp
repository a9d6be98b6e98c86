#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drivers/wire/mavlink/mavlink.hpp"
#include "drivers/wire/mavlink/mavlink_kinds.hpp"
#include "drivers/wire/mavlink/mavlink_layout.hpp"
#include "tests/npm/node.hpp"

/// Our frames, read by the library node-mavlink.
namespace drydock::wire::testing {
namespace mavlink_node_test {

using namespace mavlink;
using nlohmann::json;

std::string hex_of(const std::vector<Mavlink::Message>& messages) {
  std::string digits;
  for (const auto& message : messages) {
    std::array<std::uint8_t, Mavlink::max_frame> frame;
    const std::size_t size = encode(message, frame);
    for (const std::uint8_t byte : std::span(frame).first(size))
      digits += fmt::format("{:02x}", byte);
  }
  return digits;
}

json read_by_node(const std::vector<Mavlink::Message>& messages) {
  return test::run_node("tests/drivers/wire/read_mavlink.cjs", {hex_of(messages)});
}

TEST(MavlinkByNode, ReadsEveryMessageThatWeWrite) {
  DRYDOCK_NEEDS_NODE();
  Odometry odometry{.sender = {3, 197, 9}, .time = std::chrono::microseconds{1700000000000001}};
  odometry.attitude.fill(NAN);
  odometry.velocity_mps = {1.5F, -0.25F, 0.125F};
  odometry.velocity_covariance[6] = 0.015625F;
  odometry.quality = 63;
  const json read =
      read_by_node({Heartbeat{.sender = {3, 197, 7}},
                    Timesync{.sender = {3, 197, 8},
                             .tc1 = std::chrono::nanoseconds{1000},
                             .ts1 = std::chrono::nanoseconds{-5},
                             .target_system = 1,
                             .target_component = 1},
                    odometry,
                    VisionPositionDelta{.sender = {3, 197, 10},
                                        .time = std::chrono::microseconds{5},
                                        .time_delta = std::chrono::microseconds{250000},
                                        .angle_rad = {0.5F, 0.25F, -0.125F},
                                        .position_m = {2, -1, 0.5F},
                                        .confidence = 75}});
  ASSERT_TRUE(read.is_object());
  const json& packets = read["packets"];
  ASSERT_EQ(packets.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(packets[i]["sequence"], 7 + i);
    EXPECT_EQ(packets[i]["system"], 3);
    EXPECT_EQ(packets[i]["component"], 197);
  }
  EXPECT_EQ(packets[0]["name"], "HEARTBEAT");
  EXPECT_EQ(packets[0]["data"]["type"], 18);      // MAV_TYPE_ONBOARD_CONTROLLER
  EXPECT_EQ(packets[0]["data"]["autopilot"], 8);  // MAV_AUTOPILOT_INVALID
  EXPECT_EQ(packets[0]["data"]["systemStatus"], 4);
  EXPECT_EQ(packets[1]["name"], "TIMESYNC");
  EXPECT_EQ(packets[1]["data"]["tc1"], 1000);
  EXPECT_EQ(packets[1]["data"]["ts1"], -5);
  EXPECT_EQ(packets[1]["data"]["targetSystem"], 1);
  EXPECT_EQ(packets[2]["name"], "ODOMETRY");
  EXPECT_EQ(packets[2]["data"]["timeUsec"], 1700000000000001);
  EXPECT_EQ(packets[2]["data"]["vx"], 1.5);
  EXPECT_EQ(packets[2]["data"]["vy"], -0.25);
  EXPECT_EQ(packets[2]["data"]["vz"], 0.125);
  EXPECT_EQ(packets[2]["data"]["q"], json::parse("[null, null, null, null]"));
  EXPECT_EQ(packets[2]["data"]["velocityCovariance"][6], 0.015625);
  EXPECT_EQ(packets[2]["data"]["frameId"], 20);
  EXPECT_EQ(packets[2]["data"]["childFrameId"], 12);
  EXPECT_EQ(packets[2]["data"]["quality"], 63);
  EXPECT_EQ(packets[3]["name"], "VISION_POSITION_DELTA");
  EXPECT_EQ(packets[3]["data"]["timeDeltaUsec"], 250000);
  EXPECT_EQ(packets[3]["data"]["angleDelta"], json::parse("[0.5, 0.25, -0.125]"));
  EXPECT_EQ(packets[3]["data"]["positionDelta"], json::parse("[2, -1, 0.5]"));
  EXPECT_EQ(packets[3]["data"]["confidence"], 75);
}

template <class... M>
json kinds_of(MessageList<M...>) {
  return json::array({json::array({M::id, crc_extra_of<M>(), M::type})...});
}

TEST(MavlinkByNode, HasTheSameNumberNameAndSeedOfEachKind) {
  DRYDOCK_NEEDS_NODE();
  json ours = kinds_of(MavlinkMessages{});
  for (const UnreadKind& kind : unread_kinds)
    ours.push_back(json::array({kind.id, kind.crc_extra, kind.name}));
  json theirs = read_by_node({})["seeds"];
  std::sort(ours.begin(), ours.end());
  std::sort(theirs.begin(), theirs.end());
  EXPECT_EQ(ours, theirs);
}

}  // namespace mavlink_node_test
}  // namespace drydock::wire::testing
