#include "drivers/wire/canopen/cia402.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::cia402 {
namespace cia402_test {

using enum DriveState;
using test::frame;
using test::text_of;

// Status words of drives in the field, with "remote" and "voltage enabled": manuals of MovingCap
// and Nanotec.
constexpr std::array<std::pair<std::uint16_t, DriveState>, 8> words_in_the_field{
    {{0x0200, not_ready_to_switch_on},
     {0x0250, switch_on_disabled},
     {0x0231, ready_to_switch_on},
     {0x0233, switched_on},
     {0x0237, operation_enabled},
     {0x0217, quick_stop_active},
     {0x021F, fault_reaction_active},
     {0x0218, fault}}};

TEST(Cia402, ReadsTheStatusWordsOfDrivesInTheField) {
  for (const auto& [word, state] : words_in_the_field) EXPECT_EQ(state_of(word), state) << word;
  EXPECT_EQ(state_of(0x0637), operation_enabled) << "target reached is another bit";
}

// ABB FEPL-02 manual, table of control word commands: each command and the transitions that it
// causes.
struct Command {
  std::uint16_t word;
  std::vector<std::pair<DriveState, DriveState>> moves;
};
const std::vector<Command> commands{
    {0x06,
     {{switch_on_disabled, ready_to_switch_on},   // transition 2
      {switched_on, ready_to_switch_on},          // 6
      {operation_enabled, ready_to_switch_on}}},  // 8
    {0x07,
     {{ready_to_switch_on, switched_on},   // 3
      {operation_enabled, switched_on}}},  // 5
    {0x0F,
     {{ready_to_switch_on, operation_enabled},   // 3 and 4
      {switched_on, operation_enabled},          // 4
      {quick_stop_active, operation_enabled}}},  // 16
    {0x00,
     {{ready_to_switch_on, switch_on_disabled},   // 7
      {operation_enabled, switch_on_disabled},    // 9
      {switched_on, switch_on_disabled},          // 10
      {quick_stop_active, switch_on_disabled}}},  // 12
    {0x02,
     {{ready_to_switch_on, switch_on_disabled},  // 7
      {switched_on, switch_on_disabled},         // 10
      {operation_enabled, quick_stop_active}}},  // 11
    {0x80, {{fault, switch_on_disabled}}},       // 15
};

TEST(Cia402, EachCommandCausesTheTransitionsOfTheProfileAndNoOther) {
  for (const Command& command : commands)
    for (const auto& row : words_in_the_field) {
      const DriveState from = row.second;
      DriveState to = from;
      for (const auto& [before, behind] : command.moves)
        if (before == from) to = behind;
      EXPECT_EQ(after(from, command.word, 0), to)
          << to_string(from) << " at control word " << command.word;
    }
}

TEST(Cia402, AFaultIsResetByTheRiseOfItsBitAlone) {
  EXPECT_EQ(after(fault, 0x80, 0x80), fault);
  EXPECT_EQ(after(fault, 0x0F, 0x80), fault);
  EXPECT_EQ(after(fault, 0x8F, 0x0F), switch_on_disabled);
}

TEST(Cia402, FromEveryStateTheWordsLeadToOperation) {
  for (const DriveState start : {switch_on_disabled, ready_to_switch_on, switched_on,
                                 quick_stop_active, fault, operation_enabled}) {
    DriveState state = start;
    std::uint16_t before = 0;
    for (int i = 0; i < 5; ++i) {
      const auto word = word_towards_operation(state);
      state = after(state, word, before);
      before = word;
    }
    EXPECT_EQ(state, operation_enabled) << to_string(start);
  }
}

// CiA 301: RPDO1 of node 11 is 20Bh, TPDO1 18Bh, least significant byte first.
TEST(Cia402, ProcessDataStandAsTheObjectsAreMapped) {
  EXPECT_EQ(text_of(encode(DriveOrder{11, 0x0F, -1820})), "20B#0F00E4F8FFFF");
  EXPECT_EQ(text_of(encode(DriveStatus{11, 0x0237, 16384})), "18B#370200400000");
  const auto order = decode_order(frame("20B#0F00E4F8FFFF"));
  ASSERT_TRUE(order);
  EXPECT_EQ(order->node, 11);
  EXPECT_EQ(order->control_word, 0x0F);
  EXPECT_EQ(order->target, -1820);
  const auto status = decode_status(frame("18B#370200400000"));
  ASSERT_TRUE(status);
  EXPECT_EQ(status->actual * radians_per_increment, std::numbers::pi / 2);
  EXPECT_FALSE(decode_status(frame("18B#3702004000")));
}

TEST(Cia402, ATargetBeyondTheNumbersOfTheWireStaysAtTheirEnd) {
  EXPECT_EQ(increments_of(2 * std::numbers::pi), 65536);
  EXPECT_EQ(increments_of(1e9), 2147483647);
  EXPECT_EQ(increments_of(-1e9), -2147483647);
}

RC_GTEST_PROP(Cia402Properties, EveryOrderComesBack, (std::uint16_t word, std::int32_t target)) {
  const std::uint8_t node = *rc::gen::inRange<std::uint8_t>(1, 128);
  const auto back = decode_order(encode(DriveOrder{node, word, target}));
  RC_ASSERT(back && back->node == node && back->control_word == word && back->target == target);
}

RC_GTEST_PROP(Cia402Properties, NoWordTakesAFaultyDriveIntoOperationAtOnce,
              (std::uint16_t word, std::uint16_t before)) {
  RC_ASSERT(after(fault, word, before) != operation_enabled);
  RC_ASSERT(after(switch_on_disabled, word, before) != operation_enabled);
}

}  // namespace cia402_test
}  // namespace drydock::wire::cia402
