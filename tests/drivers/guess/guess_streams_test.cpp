#include <gmock/gmock.h>

#include "drivers/guess/guess.hpp"
#include "tests/drivers/guess/message_streams.hpp"

/// Streams of several messages whose lengths no byte tells: the first description decodes the
/// capture that it came from.
namespace drydock::described::test {
namespace guess_streams_test {

using ::testing::HasSubstr;

class GuessOfSeveralMessages : public ::testing::TestWithParam<std::tuple<Ending, Stream::Order>> {
};

TEST_P(GuessOfSeveralMessages, FindsTheLengthOfEachAndItsSum) {
  Stream stream;
  std::tie(stream.ending, stream.order) = GetParam();
  const Ending& ending = stream.ending;
  const Buffer capture = stream.capture();
  const auto guess = guess::guess_description(capture);
  if (ending.bytes > 0)
    EXPECT_THAT(guess, HasSubstr(fmt::format("checksum = \"{}\"\n", ending.name)));
  else
    EXPECT_THAT(guess, HasSubstr("# no checksum was found"));
  for (const auto& [id, values] : {std::pair{0x11, 3}, {0x12, 7}, {0x20, 10}})
    EXPECT_THAT(guess, HasSubstr(fmt::format("name = \"frame_{0:02X}\"\nsync = \"A5 5A {0:02X}\"\n"
                                             "length = {1}\n",
                                             id, 3 + 2 * values + static_cast<int>(ending.bytes))));
  if (ending.from > 0)
    EXPECT_THAT(guess, HasSubstr(fmt::format("checksum_from = {}\n", ending.from)));
  if (ending.big) EXPECT_THAT(guess, HasSubstr("checksum_order = \"big\"\n"));
  expect_all_decoded(guess, capture, 600);
}

INSTANTIATE_TEST_SUITE_P(
    Sums, GuessOfSeveralMessages,
    ::testing::Combine(::testing::Values(Ending{}, Ending{"sum-8", 1, 0}, Ending{"sum-8", 1, 2},
                                         Ending{"sum-8", 1, 3}, Ending{"sum-16", 2, 0},
                                         Ending{"sum-16", 2, 3},
                                         Ending{"sum-16", 2, 2, false, true},
                                         Ending{"sum-8-negative", 1, 0, true},
                                         Ending{"sum-8-negative", 1, 3, true},
                                         Ending{"sum-16-negative", 2, 0, true},
                                         Ending{"sum-16-negative", 2, 2, true, true}),
                       ::testing::Values(Stream::Order::random, Stream::Order::in_turn,
                                         Stream::Order::mostly_one)));

TEST(GuessOfSeveralMessages, BeginsWhereTheCaptureIsCut) {
  Stream stream;
  stream.ending = {"sum-8", 1, 2};
  Buffer capture = stream.capture();
  capture.erase(capture.begin(), capture.begin() + 5);
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("sync = \"A5 5A 11\""));
  EXPECT_EQ(RoundTrip(guess, capture).decoded.counters.frames, 599u);
}

/// FEh is the high byte of many small negative values.
TEST(GuessOfSeveralMessages, IsOfOneByteOfSyncTooThoughItStandsInTheValues) {
  for (const std::uint8_t sync : {0xAA, 0xFE}) {
    Stream stream;
    stream.head = {sync};
    stream.ending = {"sum-8", 1, 1};
    const Buffer capture = stream.capture();
    const auto guess = guess::guess_description(capture);
    EXPECT_THAT(guess, HasSubstr(fmt::format("sync = \"{:02X} 11\"\nlength = 9\n", sync)));
    expect_all_decoded(guess, capture, 600);
  }
}

/// Two frames whose bytes add up to zero do so together too. Here the identifiers 1 and 3 are the
/// lengths of the pairs that they begin, less 29.
TEST(GuessOfSeveralMessages, IsNotOfPairsOfThem) {
  Stream stream;
  stream.order = Stream::Order::in_turn;
  stream.head = {0x24, 0x40, 0x00};
  stream.kinds = {{1, 3}, {2, 7}, {3, 5}, {4, 6}};
  stream.ending = {"sum-8-negative", 1, 0, true};
  const Buffer capture = stream.capture();
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("sync = \"24 40\"\nlength = 11\n"));
  expect_all_decoded(guess, capture, 600);
}

/// One byte of sync and no checksum: nothing tells them from one long frame, so the doubt is told.
/// They are 8, 16 and 22 bytes long.
TEST(GuessOfSeveralMessages, InTurnBehindOneByteOfSyncAreToldAsDoubtful) {
  Stream stream;
  stream.head = {0xA5};
  stream.kinds = {{0x11, 3}, {0x12, 7}, {0x20, 10}};
  stream.order = Stream::Order::in_turn;
  const Buffer capture = stream.capture();
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("length = 46\n"));
  EXPECT_THAT(guess,
              HasSubstr("# Doubtful: byte A5 of the beginning stands at 8 and 24 too, always: "
                        "these may be several messages in turn.\n"));
  expect_all_decoded(guess, capture, 200);
}

TEST(GuessOfNoise, OfAnyLengthIsNone) {
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    Buffer capture(seed <= 30 ? 40 * seed : 5000 * (seed - 30));
    for (auto& byte : capture) byte = static_cast<std::uint8_t>(random());
    EXPECT_EQ(guess::guess_description(capture), "") << capture.size() << " bytes, seed " << seed;
  }
}

/// Frames of one length whose values are constant twice: they are not two messages.
TEST(GuessOfSeveralMessages, IsNoneOfFramesOfOneLength) {
  Wander value(0.3, 1), other(0.2, 2);
  Buffer capture;
  for (int i = 0; i < 500; ++i) {
    Buffer frame{0x7E, 0x81};
    put(frame, static_cast<float>(value.next()));
    put(frame, 25.0F);
    put(frame, 1.0F);
    put(frame, static_cast<float>(other.next()));
    put(frame, 25.0F);
    put(frame, 2.0F);
    capture.insert(capture.end(), frame.begin(), frame.end());
  }
  EXPECT_THAT(guess::guess_description(capture), HasSubstr("sync = \"7E 81\"\nlength = 26\n"));
}

}  // namespace guess_streams_test
}  // namespace drydock::described::test
