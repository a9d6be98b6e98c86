#include <gmock/gmock.h>

#include "drivers/survey/guess.hpp"
#include "tests/drivers/described/support.hpp"

/// A first description of a capture that nobody knows.
namespace drydock::described::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using wire::testing::Buffer;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << text;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

TEST(GuessedDescription, SentencesGiveTheirChecksumAndColumns) {
  const auto guess =
      survey::guess_description(wire::testing::fixture("described/valeport-vat.txt"));
  EXPECT_THAT(guess, HasSubstr("nothing here is certain"));
  EXPECT_THAT(guess, HasSubstr("checksum = \"xor\""));
  EXPECT_THAT(guess, HasSubstr("id = \"$PRVAT\""));
  EXPECT_THAT(guess, HasSubstr("{ name = \"column_1\" },  # 0 to 0.21"));
  EXPECT_THAT(guess, HasSubstr("{ text = \"M\" },"));
}

TEST(GuessedDescription, WithAFieldNamedItIsADescription) {
  const auto guess =
      replaced(survey::guess_description(wire::testing::fixture("described/cerulean-dvpdl.txt")),
               "name = \"column_9\"", "field = \"depth_m\", unit = \"m\"");
  EXPECT_THAT(problems_of(guess), IsEmpty()) << guess;
}

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
  const auto guess = survey::guess_description(unknown_frames());
  EXPECT_THAT(guess, HasSubstr("sync = \"A5 5A\"\nlength = 10\n"));
  EXPECT_THAT(guess, HasSubstr("checksum = \"crc-16/modbus\""));
  EXPECT_THAT(guess, HasSubstr("name = \"counter_2\""));
  EXPECT_THAT(guess, HasSubstr("{ at = 3, type = \"f32\", name = \"at_3\" },  # 10 to 24.43"));
  EXPECT_THAT(guess, HasSubstr("byte 7: always 119 (0x77)"));
  const auto named = replaced(guess, "name = \"at_3\"", "field = \"depth_m\", unit = \"m\"");
  const auto description = described(named);
  const Buffer stream = unknown_frames();
  EXPECT_EQ(wire::described::scan(description->plan, wire::Bytes(stream).subspan(3)),
            wire::Scan::frame(10));
}

TEST(GuessedDescription, NoiseGivesNothing) {
  Buffer noise(4096);
  std::uint32_t word = 1;
  for (auto& byte : noise) {
    word = word * 1664525u + 1013904223u;
    byte = static_cast<std::uint8_t>(word >> 24);
  }
  EXPECT_THAT(survey::guess_description(noise), IsEmpty());
  EXPECT_THAT(survey::guess_description({}), IsEmpty());
}

}  // namespace
}  // namespace drydock::described::test
