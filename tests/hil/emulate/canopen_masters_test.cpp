#include <gtest/gtest.h>

#include "tests/hil/emulate/ordered_node.hpp"

/// What masters of other makers do with a node beyond reading it. python-canopen's PdoMap.save()
/// writes all that it knows: it switches the PDO off, writes type and mapping, and switches it on
/// again; its profile 402 falls back to SDO for the control word. Codes: CiA 301.
namespace drydock::emulate {
namespace canopen_masters_test {

using rig_config::DeviceKind;

/// An emulated node 1 after its boot, spoken to in candump's form.
struct Master {
  explicit Master(const rig_config::DeviceConfig& config)
      : node(make_emulated_device(config, trajectory, 1).value()) {
    sent.run(*node, start);
  }
  std::string ask(const std::string& text) {
    sent.frames.clear();
    node->receive(frame(text), sent.now, sent);
    return sent.frames.empty() ? "" : text_of(sent.frames.back().frame);
  }
  /// How often a frame came until a time.
  std::size_t count(std::uint32_t id, double until_s) {
    sent.frames.clear();
    sent.run(*node, at_s(until_s));
    return static_cast<std::size_t>(std::ranges::count_if(
        sent.frames, [&](const auto& message) { return message.frame.id == id; }));
  }

  Frozen trajectory{under_way()};
  std::unique_ptr<EmulatedDevice> node;
  Recorder sent;
};

constexpr auto taken = [](const std::string& answer) { return answer.substr(0, 6) == "581#60"; };

TEST(CanopenMasters, APdoIsSwitchedOffAndOnByItsCobId) {
  Master master(device(DeviceKind::imu, "cia404-imu", 10));
  EXPECT_TRUE(taken(master.ask("601#2300180181010080")));
  EXPECT_EQ(master.ask("601#4000180100000000"), "581#4300180181010080");
  master.ask("000#0101");
  EXPECT_EQ(master.count(0x181, 0.95), 0u);
  EXPECT_TRUE(taken(master.ask("601#2300180181010000")));
  EXPECT_EQ(master.count(0x181, 1.95), 10u);
  EXPECT_EQ(master.count(0x281, 2.95), 10u) << "the others go on";
  EXPECT_EQ(master.ask("601#2300180185030000"), "581#8000180130000906") << "its number is fixed";
}

TEST(CanopenMasters, WhatAMasterWritesBackIsTaken) {
  Master master(device(DeviceKind::imu, "cia404-imu", 10));
  for (const std::string frame :
       {"601#2300180181010080", "601#2F001802FE000000", "601#2F001A0000000000",
        "601#23001A0120013061", "601#23001A0220023061", "601#2F001A0002000000",
        "601#2300180181010000"})
    EXPECT_TRUE(taken(master.ask(frame))) << frame;
  master.ask("000#0101");
  EXPECT_EQ(master.count(0x181, 0.95), 9u);
  EXPECT_EQ(master.ask("601#23001A0120033061"), "581#80001A0141000406")
      << "another object cannot be mapped";
  EXPECT_EQ(master.ask("601#2F001A0001000000"), "581#80001A0041000406");
  EXPECT_EQ(master.ask("601#2B001802FE000000"), "581#8000180210000706") << "wrong length";
}

TEST(CanopenMasters, AMasterMakesItSampleOnEachThirdSync) {
  Master master(device(DeviceKind::depth, "cia404-pressure", 10));
  EXPECT_TRUE(taken(master.ask("601#2F00180203000000")));
  master.ask("000#0101");
  EXPECT_EQ(master.count(0x181, 0.95), 0u);
  std::size_t frames = 0;
  for (int i = 0; i < 9; ++i) {
    master.ask("080#");
    frames += master.count(0x181, 1 + 0.1 * i);
  }
  EXPECT_EQ(frames, 3u);
  EXPECT_TRUE(taken(master.ask("601#2F001802FF000000")));
  EXPECT_EQ(master.count(0x181, 2.85), 11u) << "from 1.8 s on, not for the time before";
  EXPECT_EQ(master.ask("601#2F001802F5000000"), "581#8000180230000906");
  master.ask("000#8201");
  EXPECT_EQ(master.ask("601#4000180200000000"), "581#4F001802FE000000") << "as after power";
}

/// 10 degrees by SDO alone: mode, control word, target.
TEST(CanopenMasters, ADriveIsOrderedBySdoToo) {
  Node node(actuator("cia402", 1));
  for (const char* frame : {"601#2F60600008000000", "601#2B40600006000000", "601#2B40600007000000",
                            "601#2B4060000F000000", "601#237A60001C070000"}) {
    node.hear(frame);
    EXPECT_EQ(text_of(node.sent.frames.back().frame).substr(0, 6), "581#60") << frame;
  }
  node.run(9);
  EXPECT_NEAR(node.at(9).stern_plane_rad, 10 * degree, 0.1 * degree);
}

TEST(CanopenMasters, AnOrderForAPdoThatIsOffIsNotTaken) {
  Node node(actuator("cia402", 1));
  node.hear("000#0101");
  node.hear("601#2F60600008000000");
  node.hear("601#2300140101020080");
  for (const char* word : {"06", "07", "0F"}) node.hear("201#" + std::string(word) + "001C070000");
  node.run(3);
  EXPECT_EQ(node.at(3).stern_plane_rad, 0);
}

}  // namespace canopen_masters_test
}  // namespace drydock::emulate
