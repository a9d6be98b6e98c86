#include "drivers/wire/canopen.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::canopen {
namespace {

using test::frame;
using test::text_of;

// Identifiers and codes: CiA 301, predefined connection set and NMT services.

TEST(CanOpen, EncodesNetworkManagementAsCia301Says) {
  EXPECT_EQ(text_of(encode(Nmt{NmtCommand::start, 5})), "000#0105");
  EXPECT_EQ(text_of(encode(Nmt{NmtCommand::reset_node, 0})), "000#8100");
  EXPECT_EQ(text_of(encode(Heartbeat{5, NodeState::boot_up})), "705#00");
  EXPECT_EQ(text_of(encode(Heartbeat{127, NodeState::operational})), "77F#05");
  EXPECT_EQ(text_of(encode(Emergency{5, 0x1000, 0x81, {1, 2, 3, 4, 5}})), "085#0010810102030405");
  EXPECT_EQ(text_of(sync_frame()), "080#");
  EXPECT_EQ(tpdo_id(1, 5), 0x185u);
  EXPECT_EQ(tpdo_id(4, 5), 0x485u);
}

TEST(CanOpen, DecodesThem) {
  const auto nmt = decode_nmt(frame("000#8005"));
  ASSERT_TRUE(nmt);
  EXPECT_EQ(nmt->command, NmtCommand::enter_pre_operational);
  EXPECT_EQ(nmt->node, 5);
  EXPECT_EQ(decode_heartbeat(frame("705#7F"))->state, NodeState::pre_operational);
  EXPECT_EQ(decode_heartbeat(frame("705#04"))->node, 5);
  EXPECT_EQ(decode_emergency(frame("085#0010810102030405"))->code, 0x1000);
  EXPECT_TRUE(is_sync(frame("080#")));
}

TEST(CanOpen, TellsItsServicesFromTheirNeighbours) {
  EXPECT_FALSE(decode_emergency(frame("080#0010810102030405")));  // SYNC is no emergency of node 0
  EXPECT_FALSE(decode_heartbeat(frame("700#05")));
  EXPECT_FALSE(decode_heartbeat(frame("780#05")));
  EXPECT_FALSE(decode_heartbeat(frame("705#R1")));
  EXPECT_FALSE(decode_heartbeat(frame("705#55")));
  EXPECT_FALSE(decode_heartbeat(frame("00000705#05")));
  EXPECT_FALSE(decode_nmt(frame("000#0305")));
}

}  // namespace
}  // namespace drydock::wire::canopen
