#include "drivers/device/bus/canopen_node.hpp"

#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace canopen_node_test {

using namespace std::chrono_literals;
using wire::canopen::Emergency;
using wire::canopen::Heartbeat;
using enum wire::canopen::NodeState;

struct Watched {
  explicit Watched(const DriverOptions& o) : node(o, {}) { node.restart(at_s(0), ear); }
  /// Lets the node act at every deadline up to `end`.
  void run(double end) {
    for (auto due = node.deadline(); due && *due <= at_s(end); due = node.deadline()) {
      node.tick(*due, ear);
    }
  }
  Ear ear;
  CanopenNode node;
};

DriverOptions node_5() {
  auto o = options(Kind::imu, "cia404-imu");
  o.address = 5;
  return o;
}

const auto start_5 = can_frame(0x000, false, {0x01, 0x05});

TEST(CanopenNode, IsStartedWhenTheBusOpensAtBootUpAndWhilePreOperational) {
  Watched w(node_5());
  w.node.on(Heartbeat{5, boot_up}, at_s(1), w.ear);
  w.node.on(Heartbeat{5, pre_operational}, at_s(2), w.ear);
  w.node.on(Heartbeat{5, operational}, at_s(3), w.ear);
  w.node.on(Heartbeat{6, boot_up}, at_s(3), w.ear);  // another node
  EXPECT_EQ(w.ear.sent_frames, (std::vector{start_5, start_5, start_5}));
  EXPECT_TRUE(w.ear.reports.empty());
}

TEST(CanopenNode, SilenceAfterAHeartbeatIsReportedOnce) {
  auto o = node_5();
  o.canopen.heartbeat_timeout = 1500ms;
  Watched w(o);
  w.node.on(Heartbeat{5, operational}, at_s(1), w.ear);
  w.node.on(Heartbeat{5, operational}, at_s(2), w.ear);
  w.run(3.49);
  EXPECT_TRUE(w.ear.reports.empty());
  w.run(100);
  EXPECT_EQ(w.ear.reports, std::vector<std::string>{"node 5 lost: no heartbeat for 1.5 s"});
  w.node.on(Heartbeat{5, operational}, at_s(101), w.ear);  // it is watched again
  w.run(200);
  EXPECT_EQ(w.ear.reports.size(), 2U);
}

TEST(CanopenNode, ANodeWithoutHeartbeatIsNotWatched) {
  Watched w(node_5());
  w.node.on(Heartbeat{5, boot_up}, at_s(1), w.ear);
  EXPECT_FALSE(w.node.deadline());
}

TEST(CanopenNode, ARestartAndAStopByAnotherMasterAreReported) {
  Watched w(node_5());
  w.node.on(Heartbeat{5, operational}, at_s(1), w.ear);
  w.node.on(Heartbeat{5, stopped}, at_s(2), w.ear);
  w.node.on(Heartbeat{5, stopped}, at_s(3), w.ear);
  w.node.on(Heartbeat{5, boot_up}, at_s(4), w.ear);
  EXPECT_EQ(w.ear.reports,
            (std::vector<std::string>{"node 5 was stopped", "node 5 has restarted"}));
}

TEST(CanopenNode, EmergenciesOfOursAreReportedInTheWordsOfCia301) {
  Watched w(node_5());
  w.node.on(Emergency{5, 0x4210, 0x09, {}}, w.ear);
  w.node.on(Emergency{6, 0x4210, 0x09, {}}, w.ear);
  w.node.on(Emergency{5, 0x0000, 0x00, {}}, w.ear);  // the fault has ended
  EXPECT_EQ(w.ear.reports,
            std::vector<std::string>{"node 5: emergency 0x4210, device temperature"});
}

TEST(CanopenNode, SendsSyncAtItsPeriodAndSkipsWhatALateHostMissed) {
  auto o = node_5();
  o.canopen.sync_period = 10ms;
  Watched w(o);
  w.run(0.05);
  const auto sync = can_frame(0x080, false, {});
  EXPECT_EQ(std::ranges::count(w.ear.sent_frames, sync), 6);  // 0, 10, ... 50 ms
  w.node.tick(at_s(0.0951), w.ear);
  EXPECT_EQ(std::ranges::count(w.ear.sent_frames, sync), 7);
  EXPECT_EQ(w.node.deadline(), at_s(0.1));
}

}  // namespace canopen_node_test
}  // namespace drydock::device::test
