#include "drivers/device/bus/can_error_text.hpp"

#include <gtest/gtest.h>

/// Bits as linux/can/error.h defines them.
namespace drydock::device::test {
namespace can_error_text_test {

std::string_view text_of(std::uint32_t error_class, std::uint8_t details = 0) {
  wire::CanFrame frame;
  frame.error = true;
  frame.id = error_class;
  frame.size = 8;
  frame.data[1] = details;
  return can_error_text(frame);
}

TEST(CanErrorText, AControllerThatReachedAnErrorStateIsToldApartFromAFullQueue) {
  EXPECT_TRUE(text_of(0x004, 0x20).starts_with("error-passive: "));
  EXPECT_TRUE(text_of(0x004, 0x10).starts_with("error-passive: "));
  EXPECT_TRUE(text_of(0x004, 0x08).starts_with("error warning: "));
  EXPECT_TRUE(text_of(0x004, 0x01).starts_with("receive overflow: "));
  EXPECT_TRUE(text_of(0x004, 0x02).starts_with("transmit overflow: "));
  EXPECT_EQ(text_of(0x204, 0x40), "error-active again");
}

TEST(CanErrorText, OfSeveralClassesTheWorstIsNamed) {
  EXPECT_TRUE(text_of(0x040 | 0x004 | 0x100, 0x20).starts_with("bus-off: "));
  EXPECT_TRUE(text_of(0x004, 0x40 | 0x20 | 0x01).starts_with("error-passive: "));
  EXPECT_EQ(text_of(0x100), "controller restarted");
  EXPECT_EQ(text_of(0), "error frame");
}

}  // namespace can_error_text_test
}  // namespace drydock::device::test
