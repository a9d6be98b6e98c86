#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "tests/drivers/described/support.hpp"
#include "tests/drivers/guess/made_frames.hpp"

/// Streams of several messages whose lengths no byte tells, with counters and plain sums, which are
/// made here byte by byte; and what a description decodes of them.
namespace drydock::described::test {

using wire::testing::Buffer;

/// How a frame ends: so many bytes of the sum of those from `from` on.
struct Ending {
  const char* name = "none";
  std::size_t bytes = 0, from = 0;
  bool negative = false, big = false;
};

inline void PrintTo(const Ending& one, std::ostream* out) {
  *out << one.name << " from " << one.from << (one.big ? " big" : "");
}

inline void end_frame(Buffer& frame, const Ending& ending) {
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

inline void expect_all_decoded(const std::string& guess, const Buffer& capture,
                               std::size_t frames) {
  ASSERT_EQ(problems_of(guess), "") << guess;
  const RoundTrip trip(guess, capture);
  EXPECT_EQ(trip.decoded.counters.frames, frames) << guess;
  EXPECT_EQ(trip.decoded.counters.bytes_skipped, 0u) << guess;
  EXPECT_EQ(trip.decoded.records.size(), frames) << guess;
}

}  // namespace drydock::described::test
