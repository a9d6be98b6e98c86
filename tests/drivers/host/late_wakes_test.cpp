#include "drivers/host/late_wakes.hpp"

#include <gmock/gmock.h>

#include "drivers/host/wake_times.hpp"

namespace drydock::host {
namespace late_wakes_test {

using namespace std::chrono_literals;

struct Woken : testing::Test {
  WakeTimes::Time start{1000s};
  WakeTimes times{start};
};

TEST_F(Woken, InTimeIsNotLate) {
  WakeTimes::Time now = start;
  for (int i = 0; i < 1000; ++i) {
    now = times.ask(now) + 400us;
    EXPECT_FALSE(times.look(now));
  }
}

TEST_F(Woken, LateIsToldOnceThoughTheTimerIsServedBehindTheLinks) {
  EXPECT_FALSE(times.look(start + 1ms)) << "it is not due yet";
  const auto late = times.look(start + WakeTimes::period + 38ms);
  ASSERT_TRUE(late);
  EXPECT_EQ(*late, 38ms);
  EXPECT_FALSE(times.look(start + WakeTimes::period + 39ms));
  times.ask(start + WakeTimes::period + 39ms);
  EXPECT_FALSE(times.look(start + 2 * WakeTimes::period + 39ms));
}

TEST(LateWakes, AreToldInOneLineWithTheirNumberAndTheWorst) {
  const measurement::Stamp due{1000s};
  LateWakes wakes;
  EXPECT_EQ(wakes.note(), "");
  wakes.on_late_wake(due, due + 1ms);
  EXPECT_EQ(wakes.note(), "") << "no raster of messages is so narrow";
  wakes.on_late_wake(due, due + 3ms);
  EXPECT_THAT(wakes.note(), testing::HasSubstr("once late, by up to 3 ms"));
  wakes.on_late_wake(due, due + 43ms);
  wakes.on_late_wake(due, due + 9ms);
  EXPECT_THAT(wakes.note(), testing::HasSubstr("3 times late, by up to 43 ms"));
}

}  // namespace late_wakes_test
}  // namespace drydock::host
