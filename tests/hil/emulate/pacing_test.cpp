#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <map>
#include <numeric>

#include "drivers/wire/can/can_bits.hpp"
#include "hil/emulate/can_pacer.hpp"
#include "hil/emulate/line_pacer.hpp"

namespace drydock::emulate {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr nanoseconds whole_messages = nanoseconds::max();

Stamp at_ns(std::int64_t ns) { return measurement::stamp_from_ns(ns); }

std::vector<std::uint8_t> message(std::size_t size, std::uint8_t first = 0) {
  std::vector<std::uint8_t> bytes(size);
  std::iota(bytes.begin(), bytes.end(), first);
  return bytes;
}

TEST(LinePacer, FortyBytesAt4800BaudTake83MillisecondsAndAThird) {
  LinePacer line(4800, whole_messages);
  line.queue(message(40), at_ns(0));
  EXPECT_FALSE(line.take(at_ns(83'333'333)));
  const auto chunk = line.take(at_ns(83'333'334));
  ASSERT_TRUE(chunk);
  EXPECT_EQ(chunk->at, at_ns(83'333'334));
  EXPECT_EQ(chunk->bytes.size(), 40);
  EXPECT_TRUE(chunk->ends_message);
  EXPECT_FALSE(line.deadline());
}

TEST(LinePacer, FortyBytesOf8E2At4800BaudTake100Milliseconds) {
  LinePacer line({4800, {8, wire::Parity::even, 2}}, whole_messages);
  line.queue(message(40), at_ns(0));
  EXPECT_FALSE(line.take(at_ns(99'999'999)));
  EXPECT_TRUE(line.take(at_ns(100'000'000)));
}

TEST(LinePacer, AMessageWaitsForTheOneBeforeIt) {
  LinePacer line(9600, whole_messages);
  line.queue(message(96), at_ns(0));           // 100 ms
  line.queue(message(48), at_ns(20'000'000));  // 50 ms
  EXPECT_EQ(line.take(at_ns(1'000'000'000))->at, at_ns(100'000'000));
  EXPECT_EQ(line.take(at_ns(1'000'000'000))->at, at_ns(150'000'000));
}

TEST(LinePacer, MessagesLeaveAtTheRateAtWhichTheyWereQueued) {
  LinePacer line(9600, whole_messages);
  line.queue(message(10), at_ns(0));
  line.set_baud(115200);
  line.queue(message(10), at_ns(0));
  const auto first = line.take(at_ns(1'000'000'000)), second = line.take(at_ns(1'000'000'000));
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->baud, 9600u);
  EXPECT_EQ(second->baud, 115200u);
  // 100 bits at each rate.
  EXPECT_NEAR(measurement::seconds(first->at - at_ns(0)), 100 / 9600.0, 1e-8);
  EXPECT_NEAR(measurement::seconds(second->at - first->at), 100 / 115200.0, 1e-8);
}

TEST(LinePacer, ChunksAreShortAndTheLastEndsWithTheMessage) {
  LinePacer line(115200, milliseconds{4});
  line.queue(message(227), at_ns(0));
  std::size_t bytes = 0;
  Stamp last{};
  for (bool ended = false; !ended;) {
    const auto chunk = line.take(*line.deadline());
    EXPECT_LE(chunk->at - last, milliseconds{4} + nanoseconds{1});
    for (const auto byte : chunk->bytes) EXPECT_EQ(byte, bytes++ & 0xFF);
    last = chunk->at;
    ended = chunk->ends_message;
  }
  EXPECT_EQ(bytes, 227);
  EXPECT_EQ(last, at_ns(19'704'862));  // 2270 bits at 115200 bit/s, rounded up
}

TEST(LinePacer, ALineThatIsOverloadedLosesWholeOldMessagesAndCountsThem) {
  LinePacer line(4800, whole_messages);  // 480 bytes per second; as many may wait
  for (std::uint8_t i = 0; i < 20; ++i) line.queue(message(60, i), at_ns(0));
  EXPECT_EQ(line.messages_lost(), 12);
  std::vector<std::uint8_t> firsts;
  while (line.deadline()) firsts.push_back(line.take(*line.deadline())->bytes[0]);
  // The first message was on the line already. The seven latest follow.
  EXPECT_EQ(firsts, (std::vector<std::uint8_t>{0, 13, 14, 15, 16, 17, 18, 19}));
}

// 960 bytes a second carry 240 bytes every 250 ms; four sentences of 80 bytes are more. What comes
// is whole, however long it goes on, and the line is full.
TEST(LinePacer, AnOverloadedLineLosesWholeSamples) {
  LinePacer line(9600, whole_messages);
  std::map<std::int64_t, int> sentences;
  std::int64_t last = 0;
  const auto take_until = [&](Stamp now) {
    while (const auto chunk = line.take(now)) {
      last = chunk->of_message.sampled_at->time_since_epoch().count();
      ++sentences[last];
    }
  };
  for (int epoch = 0; epoch < 240; ++epoch) {
    const Stamp at = at_ns(epoch * 250'000'000LL);
    take_until(at);
    for (int i = 0; i < 4; ++i) line.queue(message(80), at, at);
  }
  take_until(at_ns(60'000'000'000));
  sentences.erase(last);  // it may still be leaving
  for (const auto& [sampled_at, count] : sentences) EXPECT_EQ(count, 4) << sampled_at;
  EXPECT_GE(sentences.size(), 60 * 960 / 320 - 2);
  EXPECT_GT(line.messages_lost(), 4 * 50);
}

RC_GTEST_PROP(LinePacer, NeverSendsFasterThanTheBaudRateNorReordersNorMixes, ()) {
  const auto baud = *rc::gen::element(4800u, 38400u, 115200u, 921600u);
  LinePacer line(baud, milliseconds{*rc::gen::inRange(1, 10)}, std::chrono::hours{1});
  std::deque<std::uint8_t> expected;
  std::int64_t now = 0;
  struct Left {
    Stamp at;
    std::size_t total;
  };
  std::vector<Left> left{{at_ns(0), 0}};
  const auto drain = [&](Stamp until) {
    while (const auto chunk = line.take(until)) {
      for (const auto byte : chunk->bytes) {
        RC_ASSERT(byte == expected.front());
        expected.pop_front();
      }
      left.push_back({chunk->at, left.back().total + chunk->bytes.size()});
    }
  };
  for (int i = *rc::gen::inRange(1, 30); i > 0; --i) {
    now += *rc::gen::inRange<std::int64_t>(0, 30'000'000);
    drain(at_ns(now));
    const auto bytes =
        message(*rc::gen::inRange<std::size_t>(1, 300), static_cast<std::uint8_t>(i));
    expected.insert(expected.end(), bytes.begin(), bytes.end());
    line.queue(bytes, at_ns(now));
  }
  drain(Stamp::max());
  RC_ASSERT(expected.empty());
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (std::size_t j = i + 1; j < left.size(); ++j) {
      const double carried = measurement::seconds(left[j].at - left[i].at) * baud / 10;
      RC_ASSERT(static_cast<double>(left[j].total - left[i].total) <= carried + 1e-6 * baud / 10);
    }
  }
}

wire::CanFrame frame(std::uint32_t id, bool extended, std::vector<std::uint8_t> data) {
  wire::CanFrame f;
  f.id = id;
  f.extended = extended;
  f.size = static_cast<std::uint8_t>(data.size());
  std::copy(data.begin(), data.end(), f.data.begin());
  return f;
}

TEST(CanPacer, AFrameOfZerosIsStuffedEveryFifthBit) {
  // SOF, identifier, control and CRC of this frame are 34 zeros: one stuff bit after every five, 6
  // in total.
  EXPECT_EQ(wire::classic_bits(frame(0, false, {})), 47 + 6);
}

/// ISO 11898-1 bit by bit, for the bits that are subject to stuffing. After five equal bits the
/// sender inserts one of the other value, which counts towards the next five.
class StuffedBits {
 public:
  void put(std::uint32_t value, unsigned width) {
    while (width > 0) put_bit((value >> --width) & 1);
  }
  void put_crc() { put(crc_, 15); }
  unsigned count() const { return count_; }

 private:
  void put_bit(std::uint32_t bit) {
    const bool divide = (bit ^ (crc_ >> 14)) & 1;
    crc_ = (crc_ << 1) & 0x7FFF;
    if (divide) crc_ ^= 0x4599;
    ++count_;
    run_ = bit == last_ ? run_ + 1 : 1;
    last_ = bit;
    if (run_ == 5) {
      ++count_;
      last_ = 1 - bit;
      run_ = 1;
    }
  }

  std::uint32_t crc_ = 0;
  std::uint32_t last_ = 2;  // neither 0 nor 1, because the first bit begins a run
  unsigned run_ = 0, count_ = 0;
};

unsigned bits_one_by_one(const wire::CanFrame& frame) {
  StuffedBits bits;
  const std::uint32_t remote = frame.remote;
  bits.put(0, 1);  // start of frame
  if (frame.extended) {
    bits.put(frame.id >> 18, 11);
    bits.put(0b11, 2);  // substitute remote request, identifier extension
    bits.put(frame.id & 0x3FFFF, 18);
    bits.put(remote << 2, 3);  // and two reserved bits
  } else {
    bits.put(frame.id, 11);
    bits.put(remote << 2, 3);  // identifier extension, a reserved bit
  }
  bits.put(frame.size, 4);
  if (!frame.remote) {
    for (const std::uint8_t byte : frame.payload()) bits.put(byte, 8);
  }
  bits.put_crc();
  return bits.count() + 13;
}

RC_GTEST_PROP(CanPacer, AFramesLengthIsThatOfItsBitsOneByOne, ()) {
  wire::CanFrame f;
  f.extended = *rc::gen::arbitrary<bool>();
  f.remote = *rc::gen::arbitrary<bool>();
  f.id = *rc::gen::inRange<std::uint32_t>(0, f.extended ? 1u << 29 : 1u << 11);
  f.size = *rc::gen::inRange<std::uint8_t>(0, 9);
  for (std::uint8_t& byte : f.data)  // runs of equal bits matter most
    byte = *rc::gen::oneOf(rc::gen::arbitrary<std::uint8_t>(),
                           rc::gen::element<std::uint8_t>(0x00, 0xFF, 0xF0, 0x0F, 0x1F, 0xF8));
  RC_ASSERT(wire::classic_bits(f) == bits_one_by_one(f));  // the number of the emulated bus
  RC_ASSERT(wire::wire_bits(f) == bits_one_by_one(f));     // that of drivers
}

RC_GTEST_PROP(CanPacer, AFramesLengthLiesBetweenNoStuffingAndTheWorstCase, ()) {
  const bool extended = *rc::gen::arbitrary<bool>();
  const auto id = *rc::gen::inRange<std::uint32_t>(0, extended ? 1u << 29 : 1u << 11);
  auto data = *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
  data.resize(std::min<std::size_t>(data.size(), 8));
  const auto n = static_cast<unsigned>(data.size());
  // Davis, Burns, Bril, Lukkien: Controller Area Network schedulability analysis, Real-Time Systems
  // 35 (2007), equations 1 and 2.
  const unsigned g = extended ? 54 : 34;
  const unsigned bits = wire::classic_bits(frame(id, extended, data));
  RC_ASSERT(bits >= g + 8 * n + 13);
  RC_ASSERT(bits <= g + 8 * n + 13 + (g + 8 * n - 1) / 4);
}

TEST(CanPacer, FramesFollowEachOtherAtTheBitRate) {
  const auto f = frame(0x18FF5380, true, {0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88});
  CanPacer bus(250'000);
  bus.queue(f, 1, at_ns(1000));
  bus.queue(f, 2, at_ns(1000));
  const std::int64_t frame_ns = wire::classic_bits(f) * 4000;
  EXPECT_GE(frame_ns, 524'000);                   // 131 bits without stuffing
  EXPECT_LE(frame_ns, 640'000);                   // 160 bits at worst
  const std::int64_t intermission_ns = 3 * 4000;  // counts as bus time, but comes after the frame
  EXPECT_FALSE(bus.take(at_ns(1000 + frame_ns - intermission_ns - 1)));
  EXPECT_EQ(bus.take(at_ns(1'000'000'000))->at, at_ns(1000 + frame_ns - intermission_ns));
  const auto second = bus.take(at_ns(1'000'000'000));
  EXPECT_EQ(second->at, at_ns(1000 + 2 * frame_ns - intermission_ns));
  EXPECT_EQ(second->passage.sent_at, at_ns(1000));
  EXPECT_EQ(second->passage.began_at, at_ns(1000 + frame_ns));
  EXPECT_EQ(second->sender, 2);
}

TEST(CanPacer, AnOverloadedBusLosesTheOldestWaitingFrames) {
  CanPacer bus(250'000);
  for (std::uint32_t i = 0; i < 300; ++i) bus.queue(frame(i, false, {}), 0, at_ns(0));
  EXPECT_EQ(bus.frames_lost(), 300 - 1 - CanPacer::bound);
  EXPECT_EQ(bus.take(Stamp::max())->frame.id, 0u);
  EXPECT_EQ(bus.take(Stamp::max())->frame.id, 300 - CanPacer::bound);
}

}  // namespace
}  // namespace drydock::emulate
