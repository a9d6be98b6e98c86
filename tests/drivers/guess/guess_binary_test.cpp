#include <gmock/gmock.h>

#include <array>
#include <cstring>

#include "tests/drivers/guess/guessed.hpp"

/// First descriptions of binary frames with a checksum.
namespace drydock::described::test {
namespace guess_binary_test {

using ::testing::HasSubstr;
using wire::testing::Buffer;

/// Forty frames A5 5A, a counter, a float that rises, a constant, CRC-16/MODBUS low byte first.
Buffer unknown_frames() {
  Buffer all{0x11, 0x22, 0x33};  // the capture begins inside a frame
  for (int i = 0; i < 40; ++i) {
    Buffer frame{0xA5, 0x5A, static_cast<std::uint8_t>(i + 250)};
    const float value = 10.0F + 0.37F * static_cast<float>(i);
    std::array<std::uint8_t, 4> raw{};
    std::memcpy(raw.data(), &value, 4);
    frame.insert(frame.end(), raw.begin(), raw.end());
    frame.push_back(0x77);
    unsigned crc = 0xFFFF;
    for (const unsigned byte : frame) {
      crc ^= byte;
      for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xA001 : crc >> 1;
    }
    frame.push_back(static_cast<std::uint8_t>(crc));
    frame.push_back(static_cast<std::uint8_t>(crc >> 8));
    all.insert(all.end(), frame.begin(), frame.end());
  }
  return all;
}

TEST(GuessedDescription, FramesGiveLengthChecksumCounterAndFloat) {
  const auto guess = guess::guess_description(unknown_frames());
  EXPECT_THAT(guess, HasSubstr("sync = \"A5 5A\"\nlength = 10\n"));
  EXPECT_THAT(guess, HasSubstr("checksum = \"crc-16/modbus\""));
  EXPECT_THAT(guess, HasSubstr("name = \"counter_2\""));
  EXPECT_THAT(guess, HasSubstr("{ at = 3, type = \"f32\", name = \"at_3\" },  # 10 to 24.43"));
  EXPECT_THAT(guess, HasSubstr("byte 7: always 119 (0x77)"));
  const auto named = measured(guess, "name = \"at_3\"", "field = \"depth_m\", unit = \"m\"");
  const auto description = described(named);
  const Buffer stream = unknown_frames();
  EXPECT_EQ(wire::described::scan(description->plan, wire::Bytes(stream).subspan(3)),
            wire::Scan::frame(10));
}

/// VectorNav's binary message of yaw, pitch and roll: CRC-16/XMODEM behind the sync byte, high byte
/// first (VN-100 user manual). The CRC of "123456789" is 31C3h.
TEST(GuessedDescription, AChecksumMayBeginBehindTheSync) {
  Buffer all;
  for (int i = 0; i < 40; ++i) {
    Buffer frame{0xFA, 0x01, 0x08, 0x00};
    for (const float angle : {-120.3F + 0.7137F * static_cast<float>(i), 3.1F, -1.2F}) {
      std::array<std::uint8_t, 4> raw{};
      std::memcpy(raw.data(), &angle, 4);
      frame.insert(frame.end(), raw.begin(), raw.end());
    }
    unsigned crc = 0;
    for (const unsigned byte : wire::Bytes(frame).subspan(1)) {
      crc ^= byte << 8;
      for (int bit = 0; bit < 8; ++bit)
        crc = (crc & 0x8000 ? crc << 1 ^ 0x1021 : crc << 1) & 0xFFFF;
    }
    frame.push_back(static_cast<std::uint8_t>(crc >> 8));
    frame.push_back(static_cast<std::uint8_t>(crc));
    all.insert(all.end(), frame.begin(), frame.end());
  }
  const auto guess = guess::guess_description(all);
  EXPECT_THAT(
      guess,
      HasSubstr("checksum = \"crc-16/xmodem\"\nchecksum_order = \"big\"\nchecksum_from = 1\n"));
  EXPECT_THAT(guess,
              HasSubstr("{ at = 4, type = \"f32\", name = \"at_4\" },  # -120.3 to -92.4657"));
}

}  // namespace guess_binary_test
}  // namespace drydock::described::test
