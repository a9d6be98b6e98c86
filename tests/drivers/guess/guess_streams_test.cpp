#include <fmt/format.h>
#include <gmock/gmock.h>

#include <functional>
#include <random>

#include "drivers/guess/guess.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/drivers/guess/made_frames.hpp"

/// Streams of several messages whose lengths no byte tells, with counters and plain sums: the first
/// description decodes the capture that it came from. Sums and counters are made here, byte by
/// byte.
namespace drydock::described::test {
namespace guess_streams_test {

using ::testing::HasSubstr;
using ::testing::Not;
using wire::testing::Buffer;

/// How a frame ends: so many bytes of the sum of those from `from` on.
struct Ending {
  const char* name = "none";
  std::size_t bytes = 0, from = 0;
  bool negative = false, big = false;
};

void PrintTo(const Ending& one, std::ostream* out) {
  *out << one.name << " from " << one.from << (one.big ? " big" : "");
}

void end_frame(Buffer& frame, const Ending& ending) {
  unsigned sum = 0;
  for (std::size_t i = ending.from; i < frame.size(); ++i) sum += frame[i];
  if (ending.negative) sum = 0u - sum;
  for (std::size_t i = 0; i < ending.bytes; ++i)
    frame.push_back(static_cast<std::uint8_t>(sum >> 8 * (ending.big ? ending.bytes - 1 - i : i)));
}

/// Messages without a byte that says their length.
class Stream {
 public:
  enum class Order { random, in_turn, mostly_one };
  Buffer head{0xA5, 0x5A};
  /// Identifiers, and so many 16-bit values.
  std::vector<std::pair<std::uint8_t, int>> kinds{{0x11, 3}, {0x12, 7}, {0x20, 10}};
  Ending ending;
  Order order = Order::random;
  /// What stands between the identifier and the values of frame `i`.
  std::function<void(Buffer&, std::size_t)> middle = [](Buffer&, std::size_t) {};

  Buffer capture(std::size_t count = 600) {
    Buffer all;
    for (std::size_t i = 0; i < count; ++i) {
      const bool first = order == Order::mostly_one && random_() % 10 < 8;
      const auto& [id, values] = kinds.at(order == Order::in_turn ? i % 3
                                          : first                 ? 0
                                                                  : random_() % 3);
      Buffer frame = head;
      frame.push_back(id);
      middle(frame, i);
      for (int axis = 0; axis < values; ++axis)
        put(frame, static_cast<std::int16_t>(wander_.at(static_cast<std::size_t>(axis)).integer()));
      end_frame(frame, ending);
      all.insert(all.end(), frame.begin(), frame.end());
    }
    return all;
  }

 private:
  std::mt19937 random_{5};
  std::vector<Wander> wander_ = [] {
    std::vector<Wander> all;
    for (std::uint32_t i = 0; i < 10; ++i) all.emplace_back(2000, 40 + i);
    return all;
  }();
};

struct Decoded {
  wire::StreamCounters counters;
  std::vector<wire::described::Record> records;
};

/// Each frame of the capture, by the description that was guessed.
struct RoundTrip {
  std::shared_ptr<const wire::described::Description> description;
  Decoded decoded;

  RoundTrip(const std::string& guess, const Buffer& capture) : description(described(guess)) {
    const wire::described::Scanner scan{&description->plan};
    const auto framer = std::make_unique<wire::Framer<wire::described::longest_frame>>();
    const auto take = [&](wire::Bytes frame, std::size_t) {
      wire::described::Record record;
      if (wire::described::decode(description->plan, frame, record) ==
          wire::described::Decoded::message)
        decoded.records.push_back(record);
    };
    framer->feed(capture, scan, take);
    framer->finish(scan, take);
    decoded.counters = framer->counters();
  }
};

void expect_all_decoded(const std::string& guess, const Buffer& capture, std::size_t frames) {
  ASSERT_EQ(problems_of(guess), "") << guess;
  const RoundTrip trip(guess, capture);
  EXPECT_EQ(trip.decoded.counters.frames, frames) << guess;
  EXPECT_EQ(trip.decoded.counters.bytes_skipped, 0u) << guess;
  EXPECT_EQ(trip.decoded.records.size(), frames) << guess;
}

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
