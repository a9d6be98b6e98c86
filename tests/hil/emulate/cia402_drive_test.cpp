#include "hil/motion/ordered/ordered_thrusters.hpp"
#include "tests/hil/emulate/ordered_node.hpp"

namespace drydock::emulate {
namespace {

/// The BlueROV2, 5 m deep.
std::unique_ptr<motion::Trajectory> rov() {
  return std::make_unique<motion::OrderedThrusters>(
      rig_config::load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/thrusters.toml").value(),
      start);
}

/// The drive of the stern planes (node 1), set up by its master and in operation.
struct Drive : Node {
  explicit Drive(int instance = 1)
      : Node(actuator("cia402", instance),
             instance > 3 ? rov()
                          : std::make_unique<motion::OrderedTrajectory>(under_orders(), start)) {
    hear("000#0101");  // NMT: start node 1
    hear(instance >= 3 ? "601#2F60600003000000"
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

// CiA 402: 0006h, 0007h, 000Fh lead to "operation enabled", whose status word is 0237h, with bit 12
// in a cyclic mode, whose target it follows. 1820 of
// 65536 increments are 10 degrees (71Ch).
TEST(Cia402Drive, ADriveFollowsItsTargetInOperationAlone) {
  Drive drive;
  drive.run(1);
  EXPECT_EQ(drive.last(0x181), "181#371200000000");
  drive.hear(Drive::order("0F", "1C070000"));
  EXPECT_NEAR(drive.at(2).stern_plane_rad, 2.5 * degree, 0.03 * degree);
  drive.run(9);
  EXPECT_EQ(drive.last(0x181), "181#37121C070000");
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

// Half of 3600 r/min are 30 turns a second, 1966080 increments a second (1E0000h).
TEST(Cia402Drive, AThrusterTurnsAtItsTargetVelocityAndStopsWithoutItsMaster) {
  Drive drive(8);
  drive.hear("601#23161001D0077F00");  // 2000 ms of node 127
  drive.hear("77F#05");
  drive.hear(Drive::order("0F", "00001E00"));
  const motion::Truth turning = drive.at(2.4);
  EXPECT_NEAR(turning.thruster_radps.at(4), 60 * std::numbers::pi, 1e-4);
  EXPECT_NEAR(turning.thruster_radps.at(5), 0, 0);
  EXPECT_EQ(drive.last(0x181), "181#370600001E00");
  drive.run(3);
  EXPECT_EQ(drive.last(0x081), "081#3081110000000000");
  EXPECT_NEAR(drive.at(5).thruster_radps.at(4), 0, 1e-6);
  drive.hear(Drive::order("0F", "0000E2FF"));  // a drive in fault follows nothing
  EXPECT_NEAR(drive.at(6).thruster_radps.at(4), 0, 1e-6);
}

TEST(Cia402Drive, ADriveOfAThrusterThatIsNotThereIsRefused) {
  const motion::OrderedTrajectory fins(under_orders(), start);
  const auto made = make_emulated_device(actuator("cia402", 7), fins, 1);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().key, "instance");
  EXPECT_NE(made.error().message.find("no thruster 7, allowed: 0 to 3"), std::string::npos);
}

// CiA 402-2, profile velocity: bit 10 target reached, bit 12 speed is 0, in every mode bit 11
// internal limit active.
TEST(Cia402Drive, AShaftTellsWhetherItHasItsTargetAndWhetherItTurns) {
  Drive drive(8);
  const auto status = [&](double t) {
    drive.run(t);
    return drive.last(0x181).substr(4, 4);
  };
  EXPECT_EQ(status(0.8), "3716");
  drive.hear(Drive::order("0F", "00001E00"));
  EXPECT_EQ(status(0.9), "3702") << "the lag of the thruster is 0.1 s";
  EXPECT_EQ(status(2), "3706");
  drive.hear(Drive::order("0F", "00000A7F"));  // far beyond 60 turns a second
  EXPECT_EQ(status(4), "370A");
  drive.hear(Drive::order("0F", "00000000"));
  EXPECT_EQ(status(6), "3716");
  drive.hear(Drive::order("06", "00000000"));
  EXPECT_EQ(status(7), "3102") << "only an enabled drive has a target";
}

TEST(Cia402Drive, APlaneTellsThatItsTargetIsBeyondItsStop) {
  Drive drive;
  drive.hear(Drive::order("0F", "1C070000"));  // 10 of 20 degrees
  drive.run(1);
  EXPECT_EQ(drive.last(0x181).substr(4, 4), "3712");
  drive.hear(Drive::order("0F", "B80F0000"));  // 22.1 degrees
  drive.run(2);
  EXPECT_EQ(drive.last(0x181).substr(4, 4), "371A");
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
