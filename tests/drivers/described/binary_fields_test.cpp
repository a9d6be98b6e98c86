#include "tests/drivers/described/decoded.hpp"

/// Fields of binary frames.
namespace drydock::described::test {
namespace binary_fields_test {

using namespace wire::testing;

constexpr std::string_view toy_frame = R"(
[sensor]
title = "toy"
kind = "imu"
[protocol]
checksum = "sum-16"
[[protocol.binary]]
name = "sample"
sync = "A5 5A"
length = {at = 2, type = "u8", plus = 3}
fields = [
  {at = 3, type = "i16", field = "force_x_mps2", unit = "mg", no_value = [-32768]},
  {at = 5, type = "i16", field = "force_y_mps2", unit = "mg", order = "big"},
  {at = 7, type = "i24", field = "force_z_mps2", unit = "mg"},
  {at = 10, type = "u32", bits = [4, 12], field = "rate_x_degps", unit = "deg/s", scale = 0.1, offset = -200},
  {at = 14, type = "bcd2", field = "rate_y_degps", unit = "deg/s", order = "big"},
  {at = 16, type = "f64", field = "rate_z_degps", unit = "rad/s"},
])";

TEST(DescribedValues, BinaryFieldsHaveTheirSizeOrderBitsDigitsAndScale) {
  const auto toy = described(toy_frame);
  // By hand: -1000, 1000 (big), -2 (24 bits), 2345 in bits 4 to 15, digits 1234, 0.5 as a double.
  Buffer frame{0xA5, 0x5A, 23,   0x18, 0xFC, 0x03, 0xE8, 0xFE, 0xFF, 0xFF, 0x9F, 0x92,
               0xFF, 0xFF, 0x12, 0x34, 0,    0,    0,    0,    0,    0,    0xE0, 0x3F};
  unsigned sum = 0;
  for (const auto byte : frame) sum += byte;
  frame.push_back(static_cast<std::uint8_t>(sum));
  frame.push_back(static_cast<std::uint8_t>(sum >> 8));
  const auto record = decoded(toy, as_text(frame));
  EXPECT_DOUBLE_EQ(value_of(record, "force_x_mps2"), -9.80665);
  EXPECT_DOUBLE_EQ(value_of(record, "force_y_mps2"), 9.80665);
  EXPECT_DOUBLE_EQ(value_of(record, "force_z_mps2"), -0.0196133);
  EXPECT_NEAR(value_of(record, "rate_x_degps"), 34.5, 1e-9);  // 0x929 = 2345
  EXPECT_NEAR(value_of(record, "rate_y_degps"), 1234, 1e-9);
  EXPECT_NEAR(value_of(record, "rate_z_degps"), 28.64788975654116, 1e-12);  // 0.5 rad/s
}

TEST(DescribedValues, BinaryMessagesOfAnyContentReadBackWithinAStep) {
  using enum wire::described::Target;
  const auto toy = described(toy_frame);
  wire::described::Readings sent, got;
  for (const double x : {-30.0, -0.01, 0.0, 5.4321, 300.0}) {
    for (int i = 0; i < 6; ++i)
      sent.set(static_cast<wire::described::Target>(static_cast<int>(force_x) + i), x / 10);
    std::array<std::uint8_t, 64> bytes{};
    const auto size = encode(toy->plan, toy->plan.messages[0], sent, bytes);
    ASSERT_EQ(size, 26u);
    read(decoded(toy, as_text(wire::Bytes(bytes).first(size))), got);
    EXPECT_NEAR(*got.get(force_x), x / 10, 0.5 * 9.80665e-3);
    EXPECT_NEAR(*got.get(force_z), x / 10, 0.5 * 9.80665e-3);
    EXPECT_DOUBLE_EQ(*got.get(rate_z), x / 10);
  }
}

}  // namespace binary_fields_test
}  // namespace drydock::described::test
