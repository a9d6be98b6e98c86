#include <gtest/gtest.h>

#include "tests/hil/emulate/canopen_master.hpp"

/// What masters of other makers do with a node beyond reading it. python-canopen's PdoMap.save()
/// writes all that it knows: it switches the PDO off, writes type and mapping, and switches it on
/// again; its profile 402 falls back to SDO for the control word. Codes: CiA 301.
namespace drydock::emulate {
namespace canopen_masters_test {

using rig_config::DeviceKind;

TEST(CanopenMasters, APdoIsSwitchedOffAndOnByItsCobId) {
  Master master(device(DeviceKind::imu, "cia404-imu", 10));
  EXPECT_TRUE(taken(master.ask("601#2300180181010080")));
  EXPECT_EQ(master.ask("601#4000180100000000"), "581#4300180181010080");
  master.ask("000#0101");
  EXPECT_EQ(master.count(0x181, 0.95), 0u);
  EXPECT_TRUE(taken(master.ask("601#2300180181010000")));
  EXPECT_EQ(master.count(0x181, 1.95), 10u);
  EXPECT_EQ(master.count(0x281, 2.95), 10u) << "the others go on";
  EXPECT_EQ(master.ask("601#2300180185030000"), "581#8000180130000906")
      << "no other number while it is on";
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
  EXPECT_EQ(master.ask("601#23001A0120033061"), "581#80001A0122000008") << "not while it is on";
  EXPECT_EQ(master.ask("601#2F001A0001000000"), "581#80001A0022000008");
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
