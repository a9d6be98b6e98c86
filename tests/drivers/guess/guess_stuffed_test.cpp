#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/guess/guess.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/drivers/guess/made_frames.hpp"

/// First descriptions of packets between delimiters.
namespace drydock::described::test {
namespace guess_stuffed_test {

using ::testing::HasSubstr;
using ::testing::Not;
using wire::described::Stuffing;
using wire::testing::Buffer;

Buffer on_the_line(Stuffing stuffing, const Buffer& packet) {
  Buffer frame(2 * packet.size() + 8);
  frame.resize(wire::described::stuff(stuffing, packet, frame));
  return frame;
}

/// Two kinds of packets in turn: three numbers, or one and a clock.
Buffer packets(Stuffing stuffing, std::string_view checksum) {
  Wander x(2000, 1), y(2000, 2), z(2000, 3);
  Buffer capture;
  for (int i = 0; i < 400; ++i) {
    Buffer rates{0x42, 0x11}, depth{0x42, 0x12};
    for (Wander* axis : {&x, &y, &z}) put(rates, axis->integer(), false, 2);
    put(depth, 12'000 + x.integer(), false, 4);
    put(depth, static_cast<std::uint32_t>(20'000 * i));
    for (Buffer* packet : {&rates, &depth}) {
      if (!checksum.empty()) put_checksum(*packet, checksum, 0, false);
      const Buffer frame = on_the_line(stuffing, *packet);
      capture.insert(capture.end(), frame.begin(), frame.end());
    }
  }
  return capture;
}

TEST(GuessedStuffing, IsToldByTheChecksumOfThePackets) {
  for (const auto& [name, stuffing] :
       {std::pair{"dle", Stuffing::dle}, std::pair{"slip", Stuffing::slip},
        std::pair{"hdlc", Stuffing::hdlc}, std::pair{"cobs", Stuffing::cobs}}) {
    const Buffer capture = packets(stuffing, "crc-16/x-25");
    const auto guess = guess::guess_description(capture);
    EXPECT_THAT(
        guess, HasSubstr(fmt::format("stuffing = \"{}\"\nchecksum = \"crc-16/ibm-sdlc\"\n", name)));
    EXPECT_THAT(guess, HasSubstr("sync = \"42 11\"\nfields = [\n  { at = 2, type = \"i16\""));
    EXPECT_THAT(guess, HasSubstr("sync = \"42 12\"\n"));
    EXPECT_THAT(guess, HasSubstr("{ at = 6, type = \"u32\", name = \"at_6\" },  # 0 to 7.98e+06"));
    ASSERT_EQ(problems_of(guess), "") << guess;
    std::size_t frames = 0;
    wire::Framer<wire::described::longest_frame> framer;
    const auto description = described(guess);
    framer.feed(capture, wire::described::Scanner{&description->plan},
                [&](wire::Bytes, std::size_t) { ++frames; });
    EXPECT_EQ(frames, 800u) << guess;
  }
}

/// Trimble's TSIP has no checksum.
TEST(GuessedStuffing, OfDleNeedsNoChecksum) {
  const auto guess = guess::guess_description(packets(Stuffing::dle, ""));
  EXPECT_THAT(guess, HasSubstr("stuffing = \"dle\"\n# no checksum was found\n"));
  EXPECT_EQ(problems_of(guess), "");
}

TEST(GuessedStuffing, IsNotThatOfFramesThatOnlyBeginWithADelimiter) {
  Wander x(2000, 1);
  Buffer capture;
  for (int i = 0; i < 400; ++i) {
    Buffer frame{0x7E, 0x10};
    put(frame, x.integer(), false, 2);
    put_checksum(frame, "sum-16", 0, false);
    capture.insert(capture.end(), frame.begin(), frame.end());
  }
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, Not(HasSubstr("stuffing")));
  EXPECT_THAT(guess, HasSubstr("sync = \"7E 10\"\nlength = 6\n"));
}

}  // namespace guess_stuffed_test
}  // namespace drydock::described::test
