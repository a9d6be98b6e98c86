#include "drivers/guess/crc_pairs.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/guess/made_frames.hpp"

/// What pairs of frames say of a CRC, before any frame is summed for it.
namespace drydock::described::test {
namespace crc_pairs_test {

using guess::CrcPairs;
using guess::Sum;
using wire::described::Checksum;
using wire::described::Crc;
using wire::testing::Buffer;

Buffer noise(std::size_t size, std::mt19937& random) {
  Buffer bytes(size);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

/// Frames of a sync of two bytes, which the CRC leaves out, and of 30 random ones.
std::vector<Buffer> frames_with(std::string_view crc, bool big) {
  std::mt19937 random(17);
  std::vector<Buffer> frames;
  for (std::size_t i = 0; i < 12; ++i) {
    Buffer& frame = frames.emplace_back(Buffer{0xA5, 0x5A});
    std::ranges::copy(noise(30, random), std::back_inserter(frame));
    put_checksum(frame, crc, 2, big);
  }
  return frames;
}

guess::Frames views_of(const std::vector<Buffer>& frames) {
  return guess::Frames(frames.begin(), frames.end());
}

/// CRC(a) xor CRC(b) = linear CRC(a xor b), for messages of one length.
TEST(CrcPairs, TheXorOfTwoMessagesHasTheXorOfTheirSums) {
  std::mt19937 random(3);
  for (const Crc& crc : wire::described::crcs) {
    const Checksum sum(crc);
    const Buffer a = noise(23, random), b = noise(23, random);
    Buffer both = a;
    for (std::size_t i = 0; i < both.size(); ++i) both[i] ^= b[i];
    EXPECT_EQ(sum.linear().of(both), sum.of(a) ^ sum.of(b)) << crc.name;
  }
}

/// Of the catalogue those of the polynomial 0x8005, reflected, and no others: by chance one of
/// 65,536 comparisons would be right.
TEST(CrcPairs, AllowTheCrcsOfTheRightPolynomialAlone) {
  std::mt19937 random(17);
  std::vector<Buffer> frames;
  for (std::size_t i = 0; i < 12; ++i) {
    frames.push_back(noise(20 + i / 6, random));
    put_checksum(frames.back(), "crc-16/modbus", 0, false);
  }
  CrcPairs pairs(views_of(frames));
  for (const Crc& crc : wire::described::crcs)
    if (crc.width > 8)
      EXPECT_EQ(pairs.allow({.checksum = Checksum(crc)}),
                crc.width == 16 && crc.polynomial == 0x8005 && crc.reflected)
          << crc.name;
}

TEST(CrcPairs, AllowEachStartBeforeTheFirstByteThatChanges) {
  const std::vector<Buffer> frames = frames_with("crc-16/ibm-3740", true);
  CrcPairs pairs(views_of(frames));
  Sum sum;
  ASSERT_TRUE(Checksum::find("crc-16/ibm-3740", sum.checksum));
  for (sum.from = 0; sum.from <= 2; ++sum.from) EXPECT_TRUE(pairs.allow(sum)) << sum.from;
  for (; sum.from <= 4; ++sum.from) EXPECT_FALSE(pairs.allow(sum)) << sum.from;
}

TEST(CrcPairs, NeedOneSoundPairOfSix) {
  std::vector<Buffer> frames = frames_with("crc-32/iso-hdlc", false);
  for (std::size_t i = 0; i < 10; i += 2) frames[i][9] ^= 0x40;
  Sum sum{.from = 2};
  ASSERT_TRUE(Checksum::find("crc-32/iso-hdlc", sum.checksum));
  EXPECT_TRUE(CrcPairs(views_of(frames)).allow(sum));
  frames[10][9] ^= 0x40;
  EXPECT_FALSE(CrcPairs(views_of(frames)).allow(sum));
}

TEST(CrcPairs, OfTooFewFramesOfOneLengthAllowAll) {
  std::vector<Buffer> frames;
  std::mt19937 random(2);
  for (std::size_t i = 0; i < 20; ++i) frames.push_back(noise(10 + i, random));
  CrcPairs pairs(views_of(frames));
  for (const Crc& crc : wire::described::crcs)
    EXPECT_TRUE(pairs.allow({.checksum = Checksum(crc)})) << crc.name;
}

}  // namespace crc_pairs_test
}  // namespace drydock::described::test
