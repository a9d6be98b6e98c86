#include <gtest/gtest.h>

#include "tests/hil/emulate/canopen_master.hpp"

/// NMT states, node guarding and the watch on a master's heartbeat (CiA 301, 7.2.8 and 7.3.2).
namespace drydock::emulate {
namespace canopen_life_test {

using rig_config::DeviceKind;

rig_config::DeviceConfig pressure() { return device(DeviceKind::depth, "cia404-pressure", 10); }

wire::CanFrame guarding() {
  wire::CanFrame asked;
  asked.id = 0x701;
  asked.remote = true;
  return asked;
}

TEST(CanopenLife, StatesDecideWhatANodeDoes) {
  Master master(pressure());
  EXPECT_EQ(master.count(0x181, 0.95), 0u) << "no PDO in pre-operational";
  EXPECT_EQ(master.ask("601#4000100000000000"), "581#4300100094010200");
  master.ask("000#0201");
  EXPECT_EQ(master.ask("601#4000100000000000"), "") << "nothing in stopped";
  EXPECT_EQ(master.count(0x181, 1.95), 0u);
  EXPECT_EQ(text_of(master.sent.frames.back().frame), "701#04") << "but its heartbeat";
  master.ask("000#0101");
  EXPECT_EQ(master.count(0x181, 2.95), 10u);
  EXPECT_EQ(master.ask("000#8201"), "701#00") << "boot-up";
}

TEST(CanopenLife, GuardingIsAnsweredWithAToggleOnceThereIsNoHeartbeat) {
  Master master(pressure());
  EXPECT_EQ(master.hear(guarding()), "") << "it has a heartbeat";
  master.ask("601#2B17100000000000");
  EXPECT_EQ(master.hear(guarding()), "701#7F");
  EXPECT_EQ(master.hear(guarding()), "701#FF");
  master.ask("000#0101");
  EXPECT_EQ(master.hear(guarding()), "701#05");
  master.ask("000#0201");
  EXPECT_EQ(master.hear(guarding()), "701#84");
}

/// 100 ms times 3. Emergency 8130h; the node is then pre-operational (1029h).
TEST(CanopenLife, ANodeThatIsGuardedNoMoreIsPreOperational) {
  Master master(pressure());
  master.ask("601#2B17100000000000");
  master.ask("601#2B0C100064000000");
  master.ask("601#2F0D100003000000");
  master.ask("000#0101");
  EXPECT_EQ(master.count(0x081, 1), 0u) << "nobody has guarded it yet";
  master.hear(guarding());
  EXPECT_EQ(master.count(0x081, 1.25), 0u);
  EXPECT_EQ(master.count(0x081, 1.5), 1u);
  EXPECT_EQ(text_of(master.sent.frames.back().frame), "081#3081110000000000");
  EXPECT_EQ(master.count(0x181, 2), 0u);
  EXPECT_EQ(master.ask("601#4001100000000000"), "581#4F01100011000000");
  master.sent.frames.clear();
  master.node->receive(guarding(), master.sent.now, master.sent);
  ASSERT_EQ(master.sent.frames.size(), 2u);
  EXPECT_EQ(text_of(master.sent.frames[0].frame), "081#0000000000000000");
  EXPECT_EQ(text_of(master.sent.frames[1].frame), "701#FF");
}

TEST(CanopenLife, ALostHeartbeatIsAnErrorThatTheNodeRemembers) {
  Master master(pressure());
  EXPECT_TRUE(taken(master.ask("601#2316100164007F00")));  // 100 ms of node 127
  EXPECT_EQ(master.ask("601#4003100000000000"), "581#4F03100000000000");
  EXPECT_EQ(master.ask("601#4003100100000000"), "581#8003100124000008") << "no data";
  master.ask("77F#05");
  EXPECT_EQ(master.count(0x081, 0.5), 1u);
  EXPECT_EQ(master.ask("601#4003100000000000"), "581#4F03100001000000");
  EXPECT_EQ(master.ask("601#4003100100000000"), "581#4303100130810000");
  EXPECT_EQ(master.ask("77F#05"), "081#0000000000000000");
  EXPECT_EQ(master.ask("601#2F03100001000000"), "581#8003100030000906");
  EXPECT_TRUE(taken(master.ask("601#2F03100000000000")));
  EXPECT_EQ(master.ask("601#4003100000000000"), "581#4F03100000000000");
}

TEST(CanopenLife, EmergenciesHaveTheNumberThatAMasterGivesOrAreOff) {
  Master master(pressure());
  master.ask("601#2316100164007F00");
  EXPECT_EQ(master.ask("601#4014100000000000"), "581#4314100081000000");
  EXPECT_TRUE(taken(master.ask("601#2314100091000000")));
  master.ask("77F#05");
  EXPECT_EQ(master.count(0x091, 0.5), 1u);
  EXPECT_TRUE(taken(master.ask("601#2314100091000080")));
  EXPECT_EQ(master.ask("77F#05"), "");
}

/// 1029h, 2: stopped.
TEST(CanopenLife, AMasterDecidesWhatItsLossDoes) {
  Master master(pressure());
  master.ask("601#2316100164007F00");
  EXPECT_TRUE(taken(master.ask("601#2F29100102000000")));
  master.ask("000#0101");
  master.ask("77F#05");
  master.count(0x181, 0.5);
  EXPECT_EQ(master.ask("601#4000100000000000"), "");
}

}  // namespace canopen_life_test
}  // namespace drydock::emulate
