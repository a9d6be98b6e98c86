#include "drivers/wire/canopen/canopen.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/canopen/canopen_sdo.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::canopen {
namespace canopen_test {

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
  EXPECT_EQ(decode_heartbeat(frame("705#85"))->state, NodeState::operational)
      << "an answer to node guarding with its toggle bit";
  EXPECT_FALSE(decode_heartbeat(frame("705#80")));
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

// Codes and classes: CiA 301, table of emergency error codes.
TEST(CanOpen, PutsEmergencyCodesIntoWords) {
  EXPECT_EQ(error_text(0x0000), "error reset or no error");
  EXPECT_EQ(error_text(0x1000), "generic error");
  EXPECT_EQ(error_text(0x8130), "life guard or heartbeat error");
  EXPECT_EQ(error_text(0x8199), "communication");  // from its class
  EXPECT_EQ(error_text(0x4310), "temperature");    // from its group
  EXPECT_EQ(error_text(0xFF42), "device specific");
  EXPECT_EQ(error_text(0xA000), "error class not in CiA 301");
}

// The command bytes 40h, 23h, 2Bh, 2Fh, 43h, 4Bh, 60h, 80h are from CiA 301, SDO protocols.
TEST(CanOpen, EncodesExpeditedTransfersAsCia301Says) {
  EXPECT_EQ(text_of(encode(SdoRead{5, {0x6131, 1}})), "605#4031610100000000");
  EXPECT_EQ(text_of(encode(SdoWrite{5, {0x1017, 0}, 1000, 2})), "605#2B171000E8030000");
  EXPECT_EQ(text_of(encode(SdoWrite{5, {0x1005, 0}, 0x40000080, 4})), "605#2305100080000040");
  EXPECT_EQ(text_of(encode(SdoWrite{5, {0x1800, 2}, 1, 1})), "605#2F00180201000000");
  EXPECT_EQ(text_of(encode(SdoValue{5, {0x6131, 1}, 0x004E0000, 4})), "585#4331610100004E00");
  EXPECT_EQ(text_of(encode(SdoWritten{5, {0x1017, 0}})), "585#6017100000000000");
  EXPECT_EQ(text_of(encode(SdoAbort{5, {0x1017, 0}, 0x06020000})), "585#8017100000000206");
}

TEST(CanOpen, DecodesTheRequestsOfAClient) {
  const auto read = decode_sdo_request(frame("605#4031610100000000"));
  ASSERT_TRUE(read);
  EXPECT_EQ(std::get<SdoRead>(*read).entry, (ObjectEntry{0x6131, 1}));
  const auto write = decode_sdo_request(frame("605#2B171000E803FFFF"));  // two bytes are unused
  ASSERT_TRUE(write);
  EXPECT_EQ(std::get<SdoWrite>(*write).value, 1000u);
  EXPECT_EQ(std::get<SdoWrite>(*write).size, 2);
}

TEST(CanOpen, DecodesTheAnswersOfANode) {
  const auto value = decode_sdo_response(frame("585#4F32610103AABBCC"));  // one byte: decimals
  ASSERT_TRUE(value);
  EXPECT_EQ(std::get<SdoValue>(*value).value, 3u);
  EXPECT_EQ(std::get<SdoValue>(*value).size, 1);
  const auto unsized = decode_sdo_response(frame("585#4231610100004E00"));
  ASSERT_TRUE(unsized);
  EXPECT_EQ(std::get<SdoValue>(*unsized).value, 0x004E0000u);
  const auto refused = decode_sdo_response(frame("585#8017100002000106"));
  ASSERT_TRUE(refused);
  EXPECT_EQ(std::get<SdoAbort>(*refused).code, 0x06010002u);  // CiA 301: the object is read-only
  EXPECT_FALSE(decode_sdo_response(frame("585#410810000B000000")));  // segmented: it has no value
  EXPECT_FALSE(decode_sdo_response(frame("585#4331610100004E")));
  EXPECT_FALSE(decode_sdo_response(frame("580#4331610100004E00")));
}

}  // namespace canopen_test
}  // namespace drydock::wire::canopen
