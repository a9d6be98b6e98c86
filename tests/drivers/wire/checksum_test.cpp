#include "drivers/wire/checksum.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <rapidcheck.h>
#include <functional>
#include <numeric>

#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace checksum_test {

TEST(Checksum, FletcherOfThePublishedExamples) {
  EXPECT_EQ(fletcher8(as_bytes("")), 0);
  // A poll of UBX-MON-VER: class 0A, id 04, length 0, then CK_A 0E and CK_B 34.
  EXPECT_EQ(fletcher8(Buffer{0x0A, 0x04, 0x00, 0x00}), 0x340E);
}

RC_GTEST_PROP(Checksum, FletcherIsTheSumOfTheSums, (const Buffer& bytes)) {
  unsigned a = 0, b = 0;
  for (const auto byte : bytes) b = (b + (a = (a + byte) % 256)) % 256;
  RC_ASSERT(fletcher8(bytes) == a + 256 * b);
}

TEST(Checksum, FletcherOfALongRunOfTheLargestByte) {
  const Buffer bytes(65'535, 0xFF);
  unsigned a = 0, b = 0;
  for (const auto byte : bytes) b = (b + (a = (a + byte) % 256)) % 256;
  EXPECT_EQ(fletcher8(bytes), a + 256 * b);
}

RC_GTEST_PROP(Checksum, ByteSumIsTheSumOfTheBytes, (const Buffer& bytes)) {
  RC_ASSERT(byte_sum(bytes) == std::accumulate(bytes.begin(), bytes.end(), 0u) % 65536);
}

TEST(Checksum, ByteSumOfALongRunOfTheLargestByte) {
  EXPECT_EQ(byte_sum(Buffer(65'535, 0xFF)), 65'535u * 255u % 65'536u);
}

RC_GTEST_PROP(Checksum, XorOfAWordIsThatOfItsBytes, (std::uint64_t word)) {
  Buffer bytes(8);
  store_le<std::uint64_t>(bytes, 0, word);
  const auto expected = std::accumulate(bytes.begin(), bytes.end(), 0, std::bit_xor<>{});
  RC_ASSERT(xor_of_bytes(word) == expected);
}

}  // namespace checksum_test
}  // namespace drydock::wire::testing
