#include "drivers/wire/line_rate.hpp"

#include <gtest/gtest.h>

namespace line_rate_test {

using namespace drydock::wire;
using std::chrono::nanoseconds;

TEST(LineRate, AByteHasAStartBitItsDataItsParityAndItsStopBits) {
  EXPECT_EQ((ByteFrame{8, Parity::none, 1}.bits()), 10U);
  EXPECT_EQ((ByteFrame{8, Parity::even, 1}.bits()), 11U);
  EXPECT_EQ((ByteFrame{8, Parity::even, 2}.bits()), 12U);
  EXPECT_EQ((ByteFrame{7, Parity::even, 1}.bits()), 10U);
  EXPECT_EQ((ByteFrame{5, Parity::none, 1}.bits()), 7U);
  EXPECT_EQ((ByteFrame{8, Parity::mark, 1}.bits()), 11U);
  EXPECT_EQ((ByteFrame{8, Parity::space, 1}.bits()), 11U);
}

// 40 bytes * 12 bits / 4800 bit/s = 100 ms; as 8N1, 83.3 ms.
TEST(LineRate, FortyBytesAt4800BaudTake100MillisecondsWith8E2) {
  EXPECT_EQ((LineRate{4800, {8, Parity::even, 2}}.time_of(40)), nanoseconds{100'000'000});
  EXPECT_EQ(LineRate{4800}.time_of(40), nanoseconds{83'333'333});
  EXPECT_EQ(LineRate{}.time_of(40), nanoseconds{0});
  EXPECT_DOUBLE_EQ((LineRate{4800, {8, Parity::even, 2}}.bytes_per_second()), 400);
}

}  // namespace line_rate_test
