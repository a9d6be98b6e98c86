#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/guess/guess.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/drivers/guess/made_frames.hpp"

/// Where the numbers of frames begin, how wide they are and which byte comes first.
namespace drydock::described::test {
namespace guess_layout_test {

using ::testing::HasSubstr;
using ::testing::Not;
using wire::testing::Buffer;

constexpr int count = 400;

std::string field(std::size_t at, std::string_view type, bool big) {
  return fmt::format("{{ at = {0}, type = \"{1}\", name = \"at_{0}\"{2} }}", at, type,
                     big ? ", order = \"big\"" : "");
}

TEST(GuessedLayout, IntegersOfFourBytesHaveTheirPlaceInEitherOrder) {
  for (const bool big : {false, true}) {
    Wander x(1e6, 1), y(1e6, 2), z(1e6, 3);
    Buffer capture;
    for (int i = 0; i < count; ++i) {
      Buffer frame{0xA5, 0x5A};
      for (Wander* axis : {&x, &y, &z}) put(frame, axis->integer(), big);
      put_checksum(frame, "sum-16", 0, big);
      capture.insert(capture.end(), frame.begin(), frame.end());
    }
    const auto guess = guess::guess_description(capture);
    for (const std::size_t at : {2, 6, 10}) EXPECT_THAT(guess, HasSubstr(field(at, "i32", big)));
  }
}

/// Epson M-G370, burst: 80h, flags, three rates and three accelerations of 32 bits, a count, the
/// sum of its words, CR. The upper byte of gravity never changes.
TEST(GuessedLayout, GravityIsAsWideAsTheOtherAccelerations) {
  Wander x(1e6, 1), y(1e6, 2), z(1e6, 3), noise(1e4, 4);
  Buffer capture;
  for (int i = 0; i < count; ++i) {
    Buffer frame{0x80, 0x04, 0x00};
    for (Wander* axis : {&x, &y, &z, &x, &y}) put(frame, axis->integer(), true);
    put(frame, -160'000'000 + noise.integer(), true);
    put(frame, static_cast<std::uint16_t>(i), true);
    put_checksum(frame, "word-sum-16-big", 1, true);
    frame.push_back(0x0D);
    capture.insert(capture.end(), frame.begin(), frame.end());
  }
  const auto guess = guess::guess_description(capture);
  for (const std::size_t at : {3, 7, 11, 15, 19, 23})
    EXPECT_THAT(guess, HasSubstr(field(at, "i32", true)));
}

/// STIM300, datagram 91h: three rates and three accelerations of 24 bits, each three with a state,
/// a counter, the latency, CRC-32/MPEG-2.
TEST(GuessedLayout, OneByteIsASyncAndIntegersMayHaveThreeBytes) {
  Wander x(1e4, 1), y(1e4, 2), z(1e4, 3), noise(300, 4);
  Buffer capture;
  for (int i = 0; i < count; ++i) {
    Buffer frame{0x91};
    for (Wander* axis : {&x, &y, &z}) put(frame, axis->integer(), true, 3);
    frame.push_back(0);
    for (Wander* axis : {&x, &y}) put(frame, axis->integer(), true, 3);
    put(frame, -524'288 + noise.integer(), true, 3);
    for (const int byte : {0, 8 * i, 0x01, 0x2C}) frame.push_back(static_cast<std::uint8_t>(byte));
    put_checksum(frame, "crc-32/mpeg-2", 0, true);
    capture.insert(capture.end(), frame.begin(), frame.end());
  }
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("checksum = \"crc-32/mpeg-2\"\nchecksum_order = \"big\""));
  EXPECT_THAT(guess, HasSubstr("[[protocol.binary]]             # 400 frames"));
  EXPECT_THAT(guess, HasSubstr("sync = \"91\"\nlength = 28"));
  for (const std::size_t at : {1, 4, 7, 11, 14, 17})
    EXPECT_THAT(guess, HasSubstr(field(at, "i24", true)));
  EXPECT_EQ(problems_of(guess), "");
}

/// 3DM-GX3, command CBh: nine floats, a clock of 62.5 kHz, the sum of all bytes.
Buffer gx3_frames() {
  Wander force(0.05, 1), rate(0.05, 2), field_gauss(0.01, 3);
  Buffer capture;
  for (int i = 0; i < count; ++i) {
    Buffer frame{0xCB};
    for (const double still : {0.0, 0.0, -1.0})
      put(frame, static_cast<float>(still + force.next()), true);
    for (int axis = 0; axis < 3; ++axis) put(frame, static_cast<float>(rate.next()), true);
    for (const double still : {0.1, 0.2, 0.4})
      put(frame, static_cast<float>(still + field_gauss.next()), true);
    put(frame, static_cast<std::uint32_t>(625 * i), true);
    put_checksum(frame, "sum-16", 0, true);
    capture.insert(capture.end(), frame.begin(), frame.end());
  }
  return capture;
}

TEST(GuessedLayout, TheChecksumTellsWhereAFrameBegins) {
  const auto guess = guess::guess_description(gx3_frames());
  EXPECT_THAT(guess, HasSubstr("checksum = \"sum-16\"\nchecksum_order = \"big\"\n"));
  EXPECT_THAT(guess, HasSubstr("sync = \"CB\"\nlength = 43"));
  for (const std::size_t at : {1, 5, 9, 13, 17, 21, 25, 29, 33})
    EXPECT_THAT(guess, HasSubstr(field(at, "f32", true)));
  EXPECT_THAT(guess, HasSubstr(field(37, "u32", true) + ",  # 0 to 249375"));
}

TEST(GuessedLayout, SaysHowMuchItLeavesOut) {
  Buffer capture = gx3_frames();
  EXPECT_THAT(guess::guess_description(capture), HasSubstr("all bytes of the capture"));
  capture.insert(capture.begin() + 43 * 100, {1, 2, 3, 4, 5, 6, 7});
  EXPECT_THAT(guess::guess_description(capture),
              HasSubstr("# Not described: 7 of 17207 bytes of the capture"));
}

/// MIP, 75h 65h: a field of time is a double of seconds, whose two upper bytes never change.
TEST(GuessedLayout, ADoubleMayBeginWithBytesThatNeverChange) {
  Wander rate(0.1, 1);
  Buffer capture;
  for (int i = 0; i < count; ++i) {
    Buffer frame{0x75, 0x65, 0x80, 0x14, 0x06, 0x05};
    put(frame, static_cast<float>(rate.next()), true);
    frame.insert(frame.end(), {0x0E, 0x12});
    put(frame, 1000 + 0.01 * i, true);
    put(frame, std::uint32_t{0x08340001}, true);
    put_checksum(frame, "fletcher-16", 0, false);
    capture.insert(capture.end(), frame.begin(), frame.end());
  }
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr(field(6, "f32", true)));
  EXPECT_THAT(guess, HasSubstr(field(12, "f64", true) + ",  # 1000 to 1003.99"));
}

/// WitMotion: 55h, kind, four numbers of 16 bits, the sum of all bytes.
TEST(GuessedLayout, MessagesThatAlternateAreMessagesOfTheirOwn) {
  Wander force(30, 1), rate(30, 2), angle(3000, 3);
  Buffer capture;
  for (int i = 0; i < count; ++i)
    for (const auto& [kind, values] : {std::pair{0x51, &force}, {0x52, &rate}, {0x53, &angle}}) {
      Buffer frame{0x55, static_cast<std::uint8_t>(kind)};
      for (int axis = 0; axis < 3; ++axis) put(frame, values->integer(), false, 2);
      put(frame, std::int16_t{2500});
      put_checksum(frame, "sum-8", 0, false);
      capture.insert(capture.end(), frame.begin(), frame.end());
    }
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("checksum = \"sum-8\"\n"));
  for (const char* sync : {"55 51", "55 52", "55 53"})
    EXPECT_THAT(guess, HasSubstr(fmt::format("sync = \"{}\"\nlength = 11\n", sync)));
  EXPECT_THAT(guess, HasSubstr(field(2, "i16", false)));
  EXPECT_EQ(problems_of(guess), "");
}

}  // namespace guess_layout_test
}  // namespace drydock::described::test
