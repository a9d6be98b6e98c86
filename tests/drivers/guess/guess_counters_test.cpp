#include <gmock/gmock.h>

#include "drivers/guess/guess.hpp"
#include "tests/drivers/guess/message_streams.hpp"

/// Counters and plain sums of streams of several messages.
namespace drydock::described::test {
namespace guess_counters_test {

using ::testing::HasSubstr;
using ::testing::Not;

struct Counter {
  const char* type;
  std::size_t bytes;
  bool big;
  std::uint32_t first;
};

void PrintTo(const Counter& one, std::ostream* out) {
  *out << one.type << (one.big ? " big" : "") << " from " << one.first;
}

class GuessOfCounters : public ::testing::TestWithParam<Counter> {};

/// One count for all messages.
TEST_P(GuessOfCounters, FindsThoseOfSeveralBytes) {
  const Counter& counter = GetParam();
  Stream stream;
  stream.ending = {"sum-8", 1, 2};
  stream.middle = [&](Buffer& frame, std::size_t i) {
    put(frame, static_cast<std::uint32_t>(counter.first + i), counter.big, counter.bytes);
  };
  const Buffer capture = stream.capture();
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr(fmt::format("{{ at = 3, type = \"{}\", name = \"counter_3\"{} }},",
                                           counter.type, counter.big ? ", order = \"big\"" : "")));
  expect_all_decoded(guess, capture, 600);
  const RoundTrip trip(guess, capture);
  for (std::size_t i = 0; i < trip.decoded.records.size(); ++i)
    ASSERT_EQ(value_of(trip.decoded.records[i], "counter_3"),
              (counter.first + i) & (counter.bytes == 4 ? 0xFFFFFFFF : 0xFFFF));
}

INSTANTIATE_TEST_SUITE_P(Kinds, GuessOfCounters,
                         ::testing::Values(Counter{"u16", 2, false, 7}, Counter{"u16", 2, true, 7},
                                           Counter{"u16", 2, false, 65300},
                                           Counter{"u16", 2, true, 65300},
                                           Counter{"u32", 4, false, 0}, Counter{"u32", 4, true, 0},
                                           Counter{"u32", 4, false, 0x12FFFF00},
                                           Counter{"u32", 4, true, 0x12FFFF00}));

/// Of a count of four bytes whose upper two never changed, and are not 0, nothing tells them from
/// constants. One that turned at 65535 without them has two.
TEST(GuessOfCounters, OfTwoBytesMayHaveThoseAboveThatNeverChanged) {
  const auto guess_of = [](std::uint32_t first, bool big) {
    Stream stream;
    stream.ending = {"sum-8", 1, 2};
    stream.middle = [&](Buffer& frame, std::size_t i) {
      put(frame, 0x1234'0000 | ((static_cast<std::uint32_t>(first + i)) & 0xFFFF), big);
    };
    return guess::guess_description(stream.capture());
  };
  EXPECT_THAT(
      guess_of(250, false),
      HasSubstr("{ at = 3, type = \"u16\", name = \"counter_3\" },  # 250 to 849; or u32 at "
                "3, of which two bytes never changed\n"));
  EXPECT_THAT(guess_of(250, true),
              HasSubstr("{ at = 5, type = \"u16\", name = \"counter_5\", order = \"big\" },  # 250 "
                        "to 849; or u32 at 3, of which two bytes never changed\n"));
  EXPECT_THAT(guess_of(65300, false), Not(HasSubstr("u32")));
}

TEST(GuessOfCounters, OneOfEachMessageCountsItsOwn) {
  Stream stream;
  stream.order = Stream::Order::in_turn;
  stream.ending = {"sum-16", 2, 0};
  stream.middle = [](Buffer& frame, std::size_t i) {
    put(frame, static_cast<std::uint16_t>(250 + i / 3), true);
  };
  const Buffer capture = stream.capture();
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess,
              HasSubstr("{ at = 3, type = \"u16\", name = \"counter_3\", order = \"big\" },  "
                        "# 250 to 449"));
  expect_all_decoded(guess, capture, 600);
}

TEST(GuessOfCounters, OneByteThatTurnsIsNotSaidToHaveTwo) {
  Stream stream;
  stream.ending = {"sum-8", 1, 0};
  stream.middle = [](Buffer& frame, std::size_t i) {
    put(frame, static_cast<std::uint8_t>(i));
    frame.push_back(0);
  };
  const auto guess = guess::guess_description(stream.capture());
  EXPECT_THAT(guess, HasSubstr("{ at = 3, type = \"u8\", name = \"counter_3\" },"));
  EXPECT_THAT(guess, Not(HasSubstr("\"u16\"")));
}

/// The sum of the header alone: sync, identifier and count; the values have none.
TEST(GuessOfSums, OfAHeaderAloneAreFound) {
  Stream stream;
  stream.middle = [](Buffer& frame, std::size_t i) {
    put(frame, static_cast<std::uint16_t>(i));
    unsigned sum = 0;
    for (const unsigned byte : frame) sum += byte;
    frame.push_back(static_cast<std::uint8_t>(0u - sum));
  };
  const Buffer capture = stream.capture();
  const auto guess = guess::guess_description(capture);
  EXPECT_THAT(guess,
              HasSubstr("header_checksum = { checksum = \"sum-8-negative\", at = 5, from = 0, "
                        "to = 5 }\n"));
  expect_all_decoded(guess, capture, 600);
}

/// The sum of the values, which stands in front of them.
TEST(GuessOfSums, OfThePayloadThatStandInTheHeaderAreFound) {
  for (const Stream::Order order : {Stream::Order::random, Stream::Order::in_turn}) {
    Stream stream;
    stream.order = order;
    Buffer capture = stream.capture(), whole;
    for (std::size_t at = 0; at < capture.size();) {
      const std::size_t size = capture[at + 2] == 0x11 ? 9 : capture[at + 2] == 0x12 ? 17 : 23;
      unsigned sum = 0;
      for (std::size_t i = at + 3; i < at + size; ++i) sum += capture[i];
      whole.insert(whole.end(), capture.begin() + std::ptrdiff_t(at),
                   capture.begin() + std::ptrdiff_t(at + 3));
      put(whole, static_cast<std::uint16_t>(sum), true);
      whole.insert(whole.end(), capture.begin() + std::ptrdiff_t(at + 3),
                   capture.begin() + std::ptrdiff_t(at + size));
      at += size;
    }
    const auto guess = guess::guess_description(whole);
    EXPECT_THAT(guess, HasSubstr("checksum = \"sum-16\"\nchecksum_order = \"big\"\n"
                                 "checksum_from = 5\nchecksum_at = 3\n"));
    expect_all_decoded(guess, whole, 600);
  }
}

/// The sum of the values alone behind a header of nine bytes, in frames of one length.
TEST(GuessOfSums, OfThePayloadAloneAreFound) {
  for (const Ending& ending : {Ending{"sum-8", 1, 9}, Ending{"sum-8-negative", 1, 9, true},
                               Ending{"sum-16", 2, 9}, Ending{"sum-16", 2, 9, false, true}}) {
    Wander x(2000, 1), y(2000, 2), z(2000, 3);
    Buffer capture;
    for (std::uint32_t i = 0; i < 600; ++i) {
      Buffer frame{0xC3, 0x3C, 0x10, 0x00, 0x07};
      put(frame, 0x01FFFF00 + i);
      for (Wander* axis : {&x, &y, &z}) put(frame, static_cast<std::int16_t>(axis->integer()));
      end_frame(frame, ending);
      capture.insert(capture.end(), frame.begin(), frame.end());
    }
    const auto guess = guess::guess_description(capture);
    EXPECT_THAT(guess, HasSubstr(fmt::format("checksum = \"{}\"\n", ending.name)));
    EXPECT_THAT(guess, HasSubstr("checksum_from = 9\n"));
    EXPECT_THAT(guess, HasSubstr("{ at = 5, type = \"u32\", name = \"counter_5\" },"));
    expect_all_decoded(guess, capture, 600);
  }
}

}  // namespace guess_counters_test
}  // namespace drydock::described::test
