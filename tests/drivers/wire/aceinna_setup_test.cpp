#include "drivers/wire/j1939/aceinna_setup.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/j1939/aceinna.hpp"
#include "drivers/wire/j1939/j1939_address_claim.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::aceinna {
namespace aceinna_setup_test {

using test::frame;
using test::text_of;

// "80 01", "80 07", "80 00 00": the examples in the comments of the vendor's DBC.
TEST(AceinnaSetup, EncodesTheExamplesOfTheVendor) {
  EXPECT_EQ(text_of(encode(PacketRate{0, 0x80, 1})), "18FF5500#8001");
  EXPECT_EQ(text_of(encode(PacketType{0, 0x80, 7})), "18FF5600#8007");
  EXPECT_EQ(text_of(encode(DigitalFilter{0, 0x80, 25, 5})), "18FF5700#801905");
  EXPECT_EQ(text_of(encode(Orientation{0, 0x80, 0})), "18FF5800#800000");
  EXPECT_EQ(text_of(encode(Orientation{0, 0x80, 0x0111})), "18FF5800#801101");
  EXPECT_EQ(text_of(j1939::encode(j1939::Request{0, 0xFF, packet_rate_pgn})), "18EAFF00#55FF00");
}

TEST(AceinnaSetup, ARealSensorsSoftwareBitIsSound) {
  const auto m = test::only<SoftwareBit, Aceinna>({frame("18FF5380#00040004AAAAAAAA")});
  EXPECT_EQ(m.source, 0x80);
  EXPECT_EQ(m.trouble(), "");
}

TEST(AceinnaSetup, TellsTheTroubleInWordsAndStatesAreNone) {
  EXPECT_EQ(HardwareBit({0x80, 0x0C}).trouble(), "internal gyro error");
  EXPECT_EQ(HardwareBit({0x80, 0x01}).trouble(), "a fatal error has occurred");
  EXPECT_EQ(SoftwareBit({0x80, 0x10}).trouble(), "sensor over range, the algorithm needs a reset");
  EXPECT_EQ(SensorStatus({0x80, 0x0580}).trouble(), "");
  EXPECT_EQ(SensorStatus({0x80, 0x1001}).trouble(), "sensor over range");
}

struct Known {
  std::uint16_t code;
  const char* text;
};

// Codes from the vendor's manual (DMU380, orientation field), for X, Y, Z.
TEST(AceinnaSetup, OrientationCodesAreTheManuals) {
  constexpr std::array<Known, 24> table{
      {{0x0000, "+X+Y+Z"}, {0x0009, "-X-Y+Z"}, {0x0023, "-Y+X+Z"}, {0x002A, "+Y-X+Z"},
       {0x0041, "-X+Y-Z"}, {0x0048, "+X-Y-Z"}, {0x0062, "+Y+X-Z"}, {0x006B, "-Y-X-Z"},
       {0x0085, "-Z+Y+X"}, {0x008C, "+Z-Y+X"}, {0x0092, "+Y+Z+X"}, {0x009B, "-Y-Z+X"},
       {0x00C4, "+Z+Y-X"}, {0x00CD, "-Z-Y-X"}, {0x00D3, "-Y+Z-X"}, {0x00DA, "+Y-Z-X"},
       {0x0111, "-X+Z+Y"}, {0x0118, "+X-Z+Y"}, {0x0124, "+Z+X+Y"}, {0x012D, "-Z-X+Y"},
       {0x0150, "+X+Z-Y"}, {0x0159, "-X-Z-Y"}, {0x0165, "-Z+X-Y"}, {0x016C, "+Z-X-Y"}}};
  for (const Known& known : table) {
    const auto axes = Axes::of_text(known.text);
    ASSERT_TRUE(axes) << known.text;
    EXPECT_EQ(axes->code(), known.code) << known.text;
    const auto back = Axes::of_code(known.code);
    ASSERT_TRUE(back) << known.text;
    EXPECT_EQ(back->output, axes->output) << known.text;
  }
  int right_handed = 0;
  for (unsigned code = 0; code <= 0xFFFF; ++code) {
    right_handed += Axes::of_code(static_cast<std::uint16_t>(code)).has_value();
  }
  EXPECT_EQ(right_handed, 24);
  EXPECT_FALSE(Axes::of_text("-X+Y+Z"));
  EXPECT_FALSE(Axes::of_text("+X+X+Z"));
  EXPECT_FALSE(Axes::of_text("+X+Y"));
}

TEST(AceinnaSetup, MagneticFieldInTesla) {
  // 32000 means 0 G, 34000 means 0.5 G (4000 per gauss from -8 G); FFFFh means not available.
  const auto m = test::only<MagneticField, Aceinna>({frame("18FF6A80#007DD084FFFFFFFF")});
  EXPECT_NEAR(m.field_t[0].value(), 0, 1e-15);
  EXPECT_NEAR(m.field_t[1].value(), 0.5e-4, 1e-15);
  EXPECT_FALSE(m.field_t[2]);
  EXPECT_EQ(text_of(encode(m)), "18FF6A80#007DD084FFFFFFFF");
}

// The trap of the reversed NAME. SAE has "arbitrary address capable" in bit 63. The vendor has it
// in bit 0, and the top of the identity number in bit 63.
TEST(AceinnaSetup, TheArbitraryAddressBitStandsAtTheOtherEndOfTheName) {
  j1939::Name movable;
  movable.arbitrary_address_capable = true;
  EXPECT_EQ(aceinna::to_value(movable), 1u);
  EXPECT_EQ(j1939::to_value(movable), std::uint64_t{1} << 63);
  EXPECT_FALSE(j1939::to_name(aceinna::to_value(movable)).arbitrary_address_capable);
  EXPECT_TRUE(aceinna::to_name(aceinna::to_value(movable)).arbitrary_address_capable);
}

TEST(AceinnaSetup, ANameWithBothBitsSetMovesInEitherReading) {
  j1939::Name name;
  name.arbitrary_address_capable = true;
  name.identity_number = 1u << 20;  // bit 63 on the wire
  j1939::AddressClaim claim(aceinna::to_value(name), 0x80);
  claim.start({});
  const auto next = claim.receive(frame("18EEFF80#0000000000000000"), {});  // a lower NAME
  ASSERT_TRUE(next);
  EXPECT_EQ(next->id, 0x18EEFF81u);
}

}  // namespace aceinna_setup_test
}  // namespace drydock::wire::aceinna
