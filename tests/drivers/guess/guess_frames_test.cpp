#include <fmt/format.h>
#include <gmock/gmock.h>

#include <random>

#include "drivers/guess/guess.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/drivers/guess/made_frames.hpp"

/// First descriptions of frames laid out as the makers' documents say, with values like a sensor's.
namespace drydock::described::test {
namespace guess_frames_test {

using ::testing::HasSubstr;
using ::testing::Not;
using wire::testing::Buffer;

constexpr int count = 1000;

/// EM 3000: status 90h, sync 90h, roll, pitch, heave, heading in .01 deg and cm, low byte first.
TEST(GuessedFrames, ASmallNumberWithASignHasItsOrder) {
  Wander roll(2, 1), pitch(1, 2), heave(0.1, 3);
  Buffer capture;
  for (int i = 0; i < count; ++i) {
    capture.insert(capture.end(), {0x90, 0x90});
    put(capture, static_cast<std::int16_t>(std::lround(100 * roll.next())));
    put(capture, static_cast<std::int16_t>(std::lround(100 * pitch.next())));
    put(capture, static_cast<std::int16_t>(std::lround(100 * heave.next())));
    put(capture, static_cast<std::uint16_t>(20000 + std::lround(2000 * std::sin(i / 150.0))));
  }
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("length = 10"));
  for (const int at : {2, 4, 6, 8})
    EXPECT_THAT(guess,
                HasSubstr(fmt::format("{{ at = {0}, type = \"i16\", name = \"at_{0}\" }}", at)));
}

/// sbgECom, message 6 (EKF_EULER): microseconds, three angles, three sigmas, status; FFh 5Ah, kind,
/// class, length, CRC-16/KERMIT from byte 2, 33h.
TEST(GuessedFrames, AClockOfFourBytesIsOneNumber) {
  Wander roll(0.05, 1), pitch(0.05, 2), heading(0.1, 3);
  Buffer capture;
  for (int i = 0; i < count; ++i) {
    Buffer frame{0xFF, 0x5A, 6, 0, 32, 0};
    put(frame, static_cast<std::uint32_t>(5'000'000 + 20'000 * i));
    for (Wander* angle : {&roll, &pitch, &heading}) put(frame, static_cast<float>(angle->next()));
    for (const float sigma : {0.001F, 0.001F, 0.01F}) put(frame, sigma);
    put(frame, std::uint32_t{0x1F});
    put_checksum(frame, "crc-16/kermit", 2, false);
    frame.push_back(0x33);
    capture.insert(capture.end(), frame.begin(), frame.end());
  }
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("checksum = \"crc-16/kermit\"\nchecksum_from = 2\nend = \"33\""));
  EXPECT_THAT(guess,
              HasSubstr("{ at = 6, type = \"u32\", name = \"at_6\" },  # 5e+06 to 2.498e+07"));
  for (const int at : {10, 14, 18})
    EXPECT_THAT(guess, HasSubstr(fmt::format("{{ at = {}, type = \"f32\"", at)));
  EXPECT_THAT(guess, HasSubstr("# bytes 22 to 37: always 6F 12 83 3A 6F 12 83 3A 0A D7"));
}

/// KVH 1750: FE 81 FF 55, three rates and three accelerations as floats, high byte first, status,
/// counter, temperature, CRC-32/MPEG-2. Noise about zero comes near it; gravity has always the same
/// upper byte.
TEST(GuessedFrames, NoiseAboutZeroAndGravityAreFloats) {
  std::mt19937 random(4);
  std::normal_distribution<float> normal;
  Buffer capture;
  for (int i = 0; i < count; ++i) {
    Buffer frame{0xFE, 0x81, 0xFF, 0x55};
    for (int axis = 0; axis < 3; ++axis) put(frame, 1e-3F * normal(random), true);
    for (const float gravity : {0.0F, 0.0F, -1.2F})
      put(frame, gravity + 0.01F * normal(random), true);
    frame.insert(frame.end(), {0x77, static_cast<std::uint8_t>(i % 128), 0, 26});
    put_checksum(frame, "crc-32/mpeg-2", 0, true);
    capture.insert(capture.end(), frame.begin(), frame.end());
  }
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("checksum = \"crc-32/mpeg-2\"\nchecksum_order = \"big\""));
  for (const int at : {4, 8, 12, 16, 20, 24})
    EXPECT_THAT(guess,
                HasSubstr(fmt::format(
                    "{{ at = {0}, type = \"f32\", name = \"at_{0}\", order = \"big\" }}", at)));
}

/// The short log INSPVAS of a NovAtel receiver, and behind it bytes that look like a line of text.
TEST(GuessedFrames, WithoutASentenceAreNotSaidToHaveSome) {
  Wander roll(1, 1), pitch(1, 2);
  Buffer capture;
  for (int i = 0; i < count; ++i) {
    Buffer frame{0xAA, 0x44, 0x13, 88, 0xFC, 1, 0xD0, 7};
    put(frame, static_cast<std::uint32_t>(20 * i));
    put(frame, std::uint32_t{2000});
    put(frame, 0.02 * i);
    put(frame, 36.1 + 1e-6 * i);
    for (const double still : {129.2, 10.0, 1.0, 0.1, 0.02}) put(frame, still);
    put(frame, roll.next());
    put(frame, pitch.next());
    put(frame, 200 + roll.next());
    put(frame, std::uint32_t{3});
    for (const char c : std::string_view("\r\n#7 ok\r\n"))
      frame.push_back(static_cast<std::uint8_t>(c));
    put_checksum(frame, "crc-32/novatel", 0, false);
    capture.insert(capture.end(), frame.begin(), frame.end());
  }
  ASSERT_NE(guess::guess_text(capture), "") << "some bytes look like lines";
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("checksum = \"crc-32/novatel\""));
  EXPECT_THAT(guess, Not(HasSubstr("carries sentences")));
  for (const int at : {16, 24, 72, 80, 88})
    EXPECT_THAT(guess, HasSubstr(fmt::format("{{ at = {}, type = \"f64\"", at)));
  EXPECT_EQ(problems_of(guess), "");
}

}  // namespace guess_frames_test
}  // namespace drydock::described::test
