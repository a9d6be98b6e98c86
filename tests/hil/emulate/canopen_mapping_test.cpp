#include <gtest/gtest.h>

#include <cstring>

#include "tests/hil/emulate/canopen_master.hpp"

/// PDOs that a master sets up anew (CiA 301, 7.5.2.33 to 7.5.2.38).
namespace drydock::emulate {
namespace canopen_mapping_test {

using rig_config::DeviceKind;

rig_config::DeviceConfig pressure() { return device(DeviceKind::depth, "cia404-pressure", 10); }

TEST(CanopenMapping, APdoHasTheObjectsAndTheNumberThatAMasterGives) {
  Master master(pressure());
  for (const char* write : {"601#2300180181010080", "601#2F001A0000000000", "601#23001A0108015061",
                            "601#23001A0220013061", "601#2F001A0002000000", "601#23001801C1010000"})
    EXPECT_TRUE(taken(master.ask(write))) << write;
  EXPECT_EQ(master.sent.told,
            (std::vector<std::string>{"TPDO1 off", "TPDO1 1C1h, type 254: 6150h:1, 6130h:1"}));
  master.ask("000#0101");
  EXPECT_EQ(master.count(0x181, 0.95), 0u);
  EXPECT_EQ(master.count(0x1C1, 1.95), 10u);
  const auto sent = master.sent.frames.back().frame;
  ASSERT_EQ(sent.size, 5) << "status, then REAL32";
  EXPECT_EQ(sent.data[0], 0);
  float pa = 0;
  std::memcpy(&pa, sent.data.data() + 1, 4);
  EXPECT_NEAR(pa, 101325 + 1025 * 9.81 * 20, 2000);
  master.ask("000#8201");
  EXPECT_EQ(master.ask("601#4000180100000000"), "581#4300180181010000") << "as after power";
}

TEST(CanopenMapping, WhatCannotBeMappedIsRefused) {
  Master master(device(DeviceKind::imu, "cia404-imu", 10));
  EXPECT_EQ(master.ask("601#2F001A0000000000"), "581#80001A0022000008") << "it is on";
  master.ask("601#2300180181010080");
  EXPECT_EQ(master.ask("601#23001A0120063061"), "581#80001A0122000008") << "its count is not 0";
  master.ask("601#2F001A0000000000");
  EXPECT_EQ(master.ask("601#23001A0120073061"), "581#80001A0141000406") << "no such object";
  EXPECT_EQ(master.ask("601#23001A0110013061"), "581#80001A0141000406") << "16 of 32 bits";
  EXPECT_EQ(master.ask("601#23001A0110001710"), "581#80001A0141000406") << "the heartbeat time";
  EXPECT_EQ(master.ask("601#2B001A0120010000"), "581#80001A0110000706") << "length";
  for (const char* write : {"601#23001A0120013061", "601#23001A0220023061", "601#23001A0320033061"})
    EXPECT_TRUE(taken(master.ask(write)));
  EXPECT_EQ(master.ask("601#2F001A0003000000"), "581#80001A0042000406") << "96 bits";
  EXPECT_EQ(master.ask("601#2F001A0009000000"), "581#80001A0042000406");
  EXPECT_TRUE(taken(master.ask("601#2F001A0002000000")));
}

TEST(CanopenMapping, NumbersOfOtherServicesAreRefused) {
  Master master(pressure());
  master.ask("601#2300180181010080");
  for (const std::string id : {"00000000", "7F000000", "01010000", "81050000", "01060000",
                               "FF060000", "01070000", "80070000", "81010020"})
    EXPECT_EQ(master.ask("601#23001801" + id), "581#8000180130000906") << id;
  EXPECT_TRUE(taken(master.ask("601#2300180180060040"))) << "bit 30: it is not asked for";
}

/// 50 ms; 1500 times 100 us.
TEST(CanopenMapping, TheEventTimerAndTheInhibitTimeAreKept) {
  Master master(pressure());
  master.ask("000#0101");
  EXPECT_EQ(master.count(0x181, 0.95), 9u);
  EXPECT_TRUE(taken(master.ask("601#2B00180532000000")));
  EXPECT_EQ(master.count(0x181, 1.95), 20u);
  EXPECT_TRUE(taken(master.ask("601#2B00180500000000")));
  master.count(0x181, 2.05);
  EXPECT_EQ(master.count(0x181, 3.05), 10u) << "at its rate again";
  EXPECT_EQ(master.ask("601#2B001803DC050000"), "581#8000180322000008") << "not while it is on";
  master.ask("601#2300180181010080");
  EXPECT_TRUE(taken(master.ask("601#2B001803DC050000")));
  master.ask("601#2300180181010000");
  EXPECT_EQ(master.count(0x181, 4.05), 5u) << "each second sample comes too soon";
}

TEST(CanopenMapping, ASyncOfAnotherNumberIsHeard) {
  Master master(pressure());
  master.ask("601#2F00180201000000");
  EXPECT_TRUE(taken(master.ask("601#2305100085000000")));
  master.ask("000#0101");
  master.ask("080#");
  EXPECT_EQ(master.count(0x181, 0.5), 0u);
  master.ask("085#");
  EXPECT_EQ(master.count(0x181, 0.6), 1u);
  master.ask("085#07");
  EXPECT_EQ(master.count(0x181, 0.7), 1u) << "with a counter";
}

TEST(CanopenMapping, ADriveTakesItsOrdersAsTheMasterMapsThem) {
  Node node(actuator("cia402", 1));
  node.hear("000#0101");
  // RPDO1: nothing of 8 bits, the target, the control word, the mode; on 321h.
  for (const char* write : {"601#2300140101020080", "601#2F00160000000000", "601#2300160108000500",
                            "601#2300160220007A60", "601#2300160310004060", "601#2300160408006060",
                            "601#2F00160004000000", "601#2300140121030000"}) {
    node.hear(write);
    EXPECT_TRUE(taken(text_of(node.sent.frames.back().frame))) << write;
  }
  for (const char* word : {"06", "07", "0F"})
    node.hear("321#EE1C070000" + std::string(word) + "0008");
  node.run(9);
  EXPECT_NEAR(node.at(9).stern_plane_rad, 10 * degree, 0.1 * degree);
}

TEST(CanopenMapping, ASynchronousOrderIsObeyedWithTheSync) {
  Node node(actuator("cia402", 1));
  node.hear("601#2F60600008000000");
  node.hear("601#2F00140201000000");
  node.hear("000#0101");
  for (const char* word : {"06", "07", "0F"}) {
    node.hear("201#" + std::string(word) + "001C070000");
    node.run(1);
    EXPECT_EQ(node.vehicle->at(at_s(1)).stern_plane_rad, 0);
    node.hear("080#");
  }
  EXPECT_NEAR(node.at(9).stern_plane_rad, 10 * degree, 0.1 * degree);
}

/// Emergency 8210h: a PDO was not processed due to its length.
TEST(CanopenMapping, AnOrderThatIsTooShortIsAnEmergency) {
  Node node(actuator("cia402", 1));
  node.hear("000#0101");
  node.hear("201#06001C07");
  EXPECT_EQ(text_of(node.sent.frames.back().frame), "081#1082110000000000");
  node.hear("201#06001C070000");
  EXPECT_EQ(text_of(node.sent.frames.back().frame), "081#0000000000000000");
}

}  // namespace canopen_mapping_test
}  // namespace drydock::emulate
