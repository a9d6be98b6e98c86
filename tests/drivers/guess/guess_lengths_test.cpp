#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/guess/guess.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/drivers/guess/made_frames.hpp"

/// Streams of frames of several lengths, in many shares and orders, with each checksum that a guess
/// tries: the first description finds every frame.
namespace drydock::described::test {
namespace guess_lengths_test {

using ::testing::HasSubstr;
using ::testing::Not;
using wire::testing::Buffer;

constexpr std::size_t count = 600;

enum class Order { random, in_turn, in_runs };
enum class Length { u8, u16, u16_big };

/// Frames: sync, length, kind, values, checksum. The length counts the values alone or all bytes.
struct Stream {
  std::string checksum;
  Order order = Order::random;
  Length length = Length::u8;
  std::vector<std::size_t> values;  ///< 16-bit values of each kind
  std::vector<double> shares;       ///< of each kind, in a random order
  bool counts_all = false, big = false;
  std::size_t checksum_from = 0;
};

void PrintTo(const Stream& s, std::ostream* out) {
  *out << fmt::format("{} order {} length {} kinds {} share {}", s.checksum,
                      static_cast<int>(s.order), static_cast<int>(s.length), s.values.size(),
                      s.shares[0]);
}

class FrameMaker {
 public:
  FrameMaker(const Stream& stream, std::uint32_t seed) : stream_(stream), random_(seed) {
    for (std::size_t i = 0; i < 16; ++i) wander_.emplace_back(3000, seed + 1 + i);
    EXPECT_TRUE(wire::described::Checksum::find(stream.checksum, sum_));
  }

  Buffer capture() {
    Buffer all;
    for (std::size_t i = 0; i < count; ++i) {
      const Buffer frame = frame_of(kind_of(i));
      all.insert(all.end(), frame.begin(), frame.end());
    }
    return all;
  }

 private:
  std::size_t kind_of(std::size_t i) {
    const std::size_t kinds = stream_.values.size();
    if (stream_.order == Order::in_turn) return i % kinds;
    if (stream_.order == Order::in_runs) return i / 20 % kinds;
    return std::discrete_distribution<std::size_t>(stream_.shares.begin(),
                                                   stream_.shares.end())(random_);
  }

  Buffer frame_of(std::size_t kind) {
    const std::size_t values = 2 * stream_.values[kind];
    const bool wide = stream_.length != Length::u8;
    const std::size_t size = 2 + (wide ? 2 : 1) + 1 + values + sum_.size();
    const auto length = static_cast<std::uint16_t>(stream_.counts_all ? size : values);
    Buffer frame{0xB5, 0x63};
    put(frame, length, stream_.length == Length::u16_big, wide ? 2 : 1);
    frame.push_back(static_cast<std::uint8_t>(kind + 1));
    for (std::size_t i = 0; i < stream_.values[kind]; ++i)
      put(frame, static_cast<std::int16_t>(wander_[i].integer()));
    put_checksum(frame, stream_.checksum, stream_.checksum_from, stream_.big);
    return frame;
  }

  const Stream& stream_;
  std::mt19937 random_;
  std::vector<Wander> wander_;
  wire::described::Checksum sum_;
};

wire::StreamCounters decoded(const std::string& description, const Buffer& capture) {
  const auto loaded = described(description);
  const wire::described::Scanner scan{&loaded->plan};
  const auto framer = std::make_unique<wire::Framer<wire::described::longest_frame>>();
  framer->feed(capture, scan, [](wire::Bytes, std::size_t) {});
  framer->finish(scan, [](wire::Bytes, std::size_t) {});
  return framer->counters();
}

std::vector<Stream> streams() {
  const std::vector<std::vector<std::size_t>> values{{6, 10}, {10, 6}, {4, 7, 12}, {12, 3, 5, 9}};
  const std::vector<std::vector<double>> shares{{90, 10, 4, 3}, {60, 40, 20, 5}, {1, 1, 1, 1}};
  std::vector<Stream> all;
  std::size_t i = 0;
  for (const std::string_view name : wire::described::checksum_names()) {
    if (name == "none") continue;
    for (const Order order : {Order::random, Order::in_turn, Order::in_runs}) {
      Stream one{std::string(name), order, static_cast<Length>(i % 3), values[i / 3 % 4], {}};
      one.shares = shares[i / 5 % 3];
      one.shares.resize(one.values.size());
      one.counts_all = i % 2 == 1;
      one.big = i / 2 % 2 == 1;
      one.checksum_from = i / 7 % 2 == 1 ? 2 : 0;
      all.push_back(std::move(one));
      ++i;
    }
  }
  return all;
}

class GuessOfFramesOfManyLengths : public ::testing::TestWithParam<Stream> {};

TEST_P(GuessOfFramesOfManyLengths, FindsEveryFrameAndItsChecksum) {
  const Buffer capture = FrameMaker(GetParam(), 7).capture();
  const std::string guess = guess::guess_description(capture);
  EXPECT_THAT(guess, HasSubstr("sync = \"B5 63"));
  EXPECT_THAT(guess, HasSubstr("checksum = "));
  ASSERT_EQ(problems_of(guess), "") << guess;
  const wire::StreamCounters found = decoded(guess, capture);
  EXPECT_EQ(found.frames, count) << guess;
  EXPECT_EQ(found.bytes_skipped, 0u);
}

INSTANTIATE_TEST_SUITE_P(Checksums, GuessOfFramesOfManyLengths, ::testing::ValuesIn(streams()));

/// Without a checksum that is known the lengths alone must lead from frame to frame.
TEST(GuessOfFramesOfManyLengths, NeedsNoChecksumThatItKnows) {
  for (const auto& shares : {std::vector<double>{90, 10}, {60, 40}, {50, 50}}) {
    Stream stream{"crc-16/modbus", Order::random, Length::u8, {6, 10}, shares};
    Buffer capture = FrameMaker(stream, 11).capture();
    std::mt19937 random(5);
    for (std::size_t at = 0; at < capture.size();) {
      const std::size_t size = capture[at + 2] + 6u;
      capture[at + size - 1] = static_cast<std::uint8_t>(random());
      at += size;
    }
    const std::string guess = guess::guess_description(capture);
    EXPECT_THAT(guess, HasSubstr("length = { at = 2, type = \"u8\", plus = 6 }"));
    ASSERT_EQ(problems_of(guess), "") << guess;
    EXPECT_EQ(decoded(guess, capture).frames, count);
  }
}

/// Bytes of noise are no lines, though many of them happen to be characters.
TEST(GuessOfNoise, IsNone) {
  std::mt19937 random(3);
  Buffer capture(40'000);
  for (auto& byte : capture) byte = static_cast<std::uint8_t>(random());
  EXPECT_EQ(guess::guess_description(capture), "");
}

}  // namespace guess_lengths_test
}  // namespace drydock::described::test
