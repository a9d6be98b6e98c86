#include "tests/hil/emulate/ordered_node.hpp"

namespace drydock::emulate {
namespace {

/// The drive of the stern planes (node 1), set up by its master and in operation.
struct Drive : Node {
  explicit Drive(int instance = 1) : Node(actuator("cia402", instance)) {
    hear("000#0101");  // NMT: start node 1
    hear(instance == 3 ? "601#2F60600003000000"
                       : "601#2F60600008000000");  // mode: velocity, position
    for (const char* word : {"06", "07", "0F"}) hear(order(word, "00000000"));
  }
  static std::string order(const std::string& word, const std::string& target) {
    return "201#" + word + "00" + target;
  }
  std::string last(std::uint32_t id) const {
    for (auto at = sent.frames.rbegin(); at != sent.frames.rend(); ++at)
      if (at->frame.id == id) return text_of(at->frame);
    return {};
  }
};

// CiA 402: 0006h, 0007h, 000Fh lead to "operation enabled", whose status word is 0237h. 1820 of
// 65536 increments are 10 degrees (71Ch).
TEST(Cia402Drive, ADriveFollowsItsTargetInOperationAlone) {
  Drive drive;
  drive.run(1);
  EXPECT_EQ(drive.last(0x181), "181#370200000000");
  drive.hear(Drive::order("0F", "1C070000"));
  EXPECT_NEAR(drive.at(2).stern_plane_rad, 2.5 * degree, 0.03 * degree);
  drive.run(9);
  EXPECT_EQ(drive.last(0x181), "181#37021C070000");
  drive.hear(Drive::order("06", "00000000"));  // shut down: it stays
  drive.run(12);
  EXPECT_EQ(drive.last(0x181), "181#31021C070000");
}

TEST(Cia402Drive, ADriveInAnotherModeDoesNotMove) {
  Node node(actuator("cia402", 1));
  node.hear("000#0101");
  node.hear("601#2F60600003000000");  // a plane has no velocity mode: 06090030h, value range
  EXPECT_EQ(text_of(node.sent.frames.back().frame), "581#8060600030000906");
  for (const char* word : {"06", "07", "0F"}) node.hear(Drive::order(word, "1C070000"));
  EXPECT_EQ(node.at(3).stern_plane_rad, 0);
}

TEST(Cia402Drive, AShaftTurnsAtItsTargetVelocity) {
  Drive drive(3);
  drive.hear(Drive::order("0F", "00000A00"));  // 655360 increments a second: ten turns
  EXPECT_NEAR(drive.at(2.5).propeller_radps, 20 * std::numbers::pi, 1e-6);
}

// CiA 301: object 1016h is node << 16 | ms; emergency 8130h is the loss of a heartbeat.
TEST(Cia402Drive, ADriveWithoutItsMastersHeartbeatFaultsStaysAndComesBack) {
  Drive drive;
  drive.hear("601#23161001F4017F00");  // 500 ms of node 127
  drive.hear(Drive::order("0F", "1C070000"));
  drive.run(1);
  drive.hear("77F#05");
  drive.run(1.45);
  EXPECT_EQ(drive.last(0x081), "");
  drive.run(2);
  EXPECT_EQ(drive.last(0x081), "081#3081110000000000");
  EXPECT_EQ(drive.last(0x181).substr(4, 4), "0802");
  const double stands = drive.at(2).stern_plane_rad;
  EXPECT_NEAR(drive.at(2).stern_plane_rad, 2.75 * degree, 0.3 * degree);
  drive.hear(Drive::order("0F", "00000000"));  // a drive in fault follows nothing
  drive.run(4);
  EXPECT_NEAR(drive.at(4).stern_plane_rad, stands, 2e-5);
  drive.hear("77F#05");
  for (const char* word : {"80", "06", "07", "0F"}) drive.hear(Drive::order(word, "00000000"));
  EXPECT_EQ(drive.last(0x081), "081#0000000000000000");
  drive.run(4.4);
  EXPECT_LT(drive.at(4.4).stern_plane_rad, stands - 0.5 * degree);
}

}  // namespace
}  // namespace drydock::emulate
