#include "drivers/device/burst.hpp"

#include <gtest/gtest.h>

namespace drydock::device::test {
namespace burst_test {

using measurement::Stamp;
using std::chrono::milliseconds;

constexpr milliseconds on_wire{4}, shortest_pause{10};

Stamp at_ms(int t) { return Stamp{milliseconds{t}}; }

/// The message ends at `end`. Alone, it would have been true when its first bit was sent.
Stamp valid(Burst& burst, int end, std::size_t kind) {
  Origin origin;
  origin.received_at = at_ms(end);
  origin.valid_at = origin.received_at - on_wire;
  return burst.of(origin, on_wire, kind).valid_at;
}

TEST(Burst, MessagesInARowWereTrueBeforeTheFirstLeft) {
  Burst burst(shortest_pause);
  EXPECT_EQ(valid(burst, 4, 0), at_ms(0));
  EXPECT_EQ(valid(burst, 8, 1), at_ms(0));
  EXPECT_EQ(valid(burst, 22, 2), at_ms(0));  // a pause of ten
}

TEST(Burst, APauseOrAKindThatComesAgainBeginsAnew) {
  Burst burst(shortest_pause);
  EXPECT_EQ(valid(burst, 4, 0), at_ms(0));
  EXPECT_EQ(valid(burst, 19, 1), at_ms(15));
  EXPECT_EQ(valid(burst, 23, 0), at_ms(15));
  EXPECT_EQ(valid(burst, 27, 1), at_ms(23)) << "a line that never rests";
}

TEST(Burst, FramesThatTheHostStampedAtOnceBelongTogether) {
  Burst burst(shortest_pause);
  EXPECT_EQ(valid(burst, 4, 0), at_ms(0));
  EXPECT_EQ(valid(burst, 4, 1), at_ms(0));
}

}  // namespace burst_test
}  // namespace drydock::device::test
