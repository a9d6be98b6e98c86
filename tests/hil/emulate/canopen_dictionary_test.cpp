#include <gtest/gtest.h>

#include "tests/hil/emulate/canopen_master.hpp"

/// The objects that every node has (CiA 301, 7.5.2), and how they are read (7.2.4). Abort codes:
/// its table 22.
namespace drydock::emulate {
namespace canopen_dictionary_test {

using rig_config::DeviceKind;

rig_config::DeviceConfig pressure() { return device(DeviceKind::depth, "cia404-pressure", 10); }

TEST(CanopenDictionary, NamesAreReadInSegments) {
  Master master(pressure());
  EXPECT_EQ(master.text("081000"), "Drydock emulated pressure transmitter");
  EXPECT_EQ(master.ask("601#4008100000000000"), "581#4108100025000000") << "37 bytes";
  EXPECT_EQ(master.ask("601#6000000000000000"), "581#00447279646F636B") << "Drydock";
  EXPECT_EQ(master.text("091000"), "emulated");
  EXPECT_EQ(master.ask("601#400A100000000000"), "581#470A1000312E3000") << "1.0, expedited";
  Master drive(actuator("cia402", 1));
  EXPECT_EQ(drive.text("081000"), "Drydock emulated drive");
}

TEST(CanopenDictionary, ASegmentOutOfTurnEndsTheTransfer) {
  Master master(pressure());
  master.ask("601#4008100000000000");
  EXPECT_EQ(master.ask("601#7000000000000000"), "581#8008100000000305") << "the toggle bit";
  EXPECT_EQ(master.ask("601#6000000000000000"), "581#8000000001000405") << "no transfer any more";
  master.ask("601#4008100000000000");
  EXPECT_EQ(master.ask("601#8008100000000405"), "") << "given up by the client";
  EXPECT_EQ(master.ask("601#6000000000000000"), "581#8000000001000405");
}

/// Byte 5 is the length up to which the client takes a transfer without blocks.
TEST(CanopenDictionary, AReadInBlocksIsRefusedOrAnsweredWithoutBlocks) {
  Master master(pressure());
  EXPECT_EQ(master.ask("601#A00810007F000000"), "581#8008100001000405");
  EXPECT_EQ(master.ask("601#A00810007F240000"), "581#8008100001000405") << "36 bytes at most";
  EXPECT_EQ(master.ask("601#A00810007F250000"), "581#4108100025000000");
  EXPECT_EQ(master.ask("601#A01710007F020000"), "581#4B171000E8030000");
  EXPECT_EQ(master.ask("601#C017100002000000"), "581#8017100001000405") << "a write in blocks";
}

TEST(CanopenDictionary, AShortObjectIsWrittenInSegmentsToo) {
  Master master(pressure());
  EXPECT_EQ(master.ask("601#2117100002000000"), "581#6017100000000000");
  EXPECT_EQ(master.ask("601#0BFA000000000000"), "581#2000000000000000");
  EXPECT_EQ(master.ask("601#4017100000000000"), "581#4B171000FA000000");
  EXPECT_EQ(master.ask("601#2117100008000000"), "581#8017100012000706") << "too long";
  master.ask("601#2017100000000000");
  EXPECT_EQ(master.ask("601#0111223344556677"), "581#8017100012000706") << "said by nobody before";
}

TEST(CanopenDictionary, AWriteWithoutASizeHasThatOfTheObject) {
  Master master(pressure());
  EXPECT_TRUE(taken(master.ask("601#22171000F401EEEE")));
  EXPECT_EQ(master.ask("601#4017100000000000"), "581#4B171000F4010000");
}

TEST(CanopenDictionary, RefusalsHaveTheirCodes) {
  Master master(pressure());
  EXPECT_EQ(master.ask("601#4034120000000000"), "581#8034120000000206") << "no object";
  EXPECT_EQ(master.ask("601#4018100500000000"), "581#8018100511000906") << "no sub-index";
  EXPECT_EQ(master.ask("601#2300100001000000"), "581#8000100002000106") << "read only";
  EXPECT_EQ(master.ask("601#2308100001000000"), "581#8008100002000106");
  EXPECT_EQ(master.ask("601#2330610101000000"), "581#8030610102000106");
  EXPECT_EQ(master.ask("601#2F17100001000000"), "581#8017100010000706") << "length";
  EXPECT_EQ(master.ask("601#2305100080000040"), "581#8005100030000906") << "it makes no SYNC";
  EXPECT_EQ(master.ask("601#2F29100103000000"), "581#8029100130000906");
}

TEST(CanopenDictionary, ANodeIdentifiesItself) {
  Master one(pressure());
  EXPECT_EQ(one.ask("601#4018100000000000"), "581#4F18100004000000");
  EXPECT_EQ(one.ask("601#4018100300000000"), "581#4318100300000100");
  const auto serial = one.ask("601#4018100400000000");
  EXPECT_EQ(serial.substr(0, 12), "581#43181004");
  auto another = pressure();
  another.name = "depth-2";
  EXPECT_NE(serial, Master(another).ask("601#4018100400000000"));
}

/// "save" and "load" in this order of bytes.
TEST(CanopenDictionary, SettingsAreSavedAndRestoredByTheirSignatures) {
  auto memory = std::make_shared<Memory>();
  const PowerUp power{start, std::make_shared<Condition>(), memory};
  {
    Master master(pressure(), power);
    EXPECT_EQ(master.ask("601#4010100100000000"), "581#4310100101000000") << "on command";
    master.ask("601#2B171000FA000000");
    EXPECT_EQ(master.ask("601#2310100165766173"), "581#8010100120000008") << "signature";
    EXPECT_EQ(master.ask("601#2B10100173610000"), "581#8010100110000706");
    master.ask("000#8201");
    EXPECT_EQ(master.ask("601#4017100000000000"), "581#4B171000E8030000") << "nothing was saved";
    master.ask("601#2B171000FA000000");
    EXPECT_TRUE(taken(master.ask("601#2310100173617665")));
  }
  Master again(pressure(), power);
  EXPECT_EQ(again.ask("601#4017100000000000"), "581#4B171000FA000000") << "also without power";
  EXPECT_TRUE(taken(again.ask("601#231110016C6F6164")));
  EXPECT_EQ(again.ask("601#4017100000000000"), "581#4B171000FA000000") << "until the reset";
  again.ask("000#8101");
  EXPECT_EQ(again.ask("601#4017100000000000"), "581#4B171000E8030000");
  EXPECT_EQ(again.ask("601#2311100173617665"), "581#8011100120000008");
}

}  // namespace canopen_dictionary_test
}  // namespace drydock::emulate
