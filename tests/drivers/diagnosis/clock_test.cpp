#include <gtest/gtest.h>

#include <random>

#include "drivers/diagnosis/monitors/clock_watch.hpp"
#include "drivers/diagnosis/monitors/rate_watch.hpp"
#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::clock_test {

using measurement::from_seconds;

/// Messages at 5 Hz, 20 ms on their way, from a clock that was learned.
struct ClockThatIsWatched : testing::Test {
  ClockThatIsWatched() {
    while (now < 31) add(0);
  }
  ClockWatch::News add(double ahead_s) {
    now += 0.2;
    return watch.add(from_seconds(5000 + now + ahead_s), at_s(now + 0.02), at_s(now + 0.01));
  }
  ClockWatch watch;
  double now = 0;
};

TEST_F(ClockThatIsWatched, HasNoNewsWhileItRuns) {
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(add(0).jump_s, 0);
}

TEST_F(ClockThatIsWatched, JumpsByWhatItIsSetAhead) { EXPECT_NEAR(add(10).jump_s, -10, 1e-6); }

TEST_F(ClockThatIsWatched, GoesBackwards) {
  EXPECT_FALSE(add(0).backwards);
  EXPECT_TRUE(add(-0.5).backwards);
}

TEST_F(ClockThatIsWatched, TellsARepeatedTime) {
  const double ahead = -0.2;
  EXPECT_TRUE(add(ahead).repeated);
}

TEST_F(ClockThatIsWatched, MayBeginAnewAtMidnight) {
  EXPECT_EQ(add(-86400).jump_s, 0);
  EXPECT_EQ(add(-86400).jump_s, 0);
}

/// Messages at 10 Hz with exponential waits of the bus of 0.3 ms in the mean.
struct RateThatIsWatched : testing::Test {
  void run(double from_s, double to_s, double ppm) {
    for (double t = from_s; t < to_s; t += 0.1) {
      device_s += 0.1 * (1 - ppm * 1e-6);
      watch.add(at_s(device_s + wait(random)), 1, 0.1);
    }
  }
  RateWatch watch;
  std::mt19937_64 random{5};
  std::exponential_distribution<double> wait{1 / 0.0003};
  double device_s = 0;
};

TEST_F(RateThatIsWatched, IsAsUsualForAnHour) {
  run(0, 40, 25);
  for (int minute = 0; minute < 60; ++minute) {
    run(0, 60, 25);
    EXPECT_FALSE(watch.change_ppm()) << *watch.change_ppm();
  }
}

TEST_F(RateThatIsWatched, IsFasterBy100PartsInAMillion) {
  run(0, 40, 25);
  run(0, 28, 125);
  ASSERT_TRUE(watch.change_ppm());
  EXPECT_NEAR(*watch.change_ppm(), 100, 15);
}

/// A fault while it learned, or a clock that has become warm: a rate that stays is the usual one.
TEST_F(RateThatIsWatched, HasANewUsualRateAfterTenMinutes) {
  run(0, 40, 125);
  run(0, 9 * 60, 25);
  ASSERT_TRUE(watch.change_ppm());
  EXPECT_NEAR(*watch.change_ppm(), -100, 15);
  run(0, 3 * 60, 25);
  EXPECT_FALSE(watch.change_ppm());
  run(0, 28, 125);
  ASSERT_TRUE(watch.change_ppm());
  EXPECT_NEAR(*watch.change_ppm(), 100, 15) << "against that one";
}

/// What was learned in a fault that held and crowded messages is no rate of a clock.
TEST_F(RateThatIsWatched, SoonForgetsARateThatNoClockHas) {
  run(0, 40, 12'000);
  run(0, 28, 0);
  EXPECT_TRUE(watch.change_ppm());
  run(0, 120, 0);
  EXPECT_FALSE(watch.change_ppm());
}

/// The same messages with the device's own time and no raster: pauses of 0.05 s to 0.2 s.
TEST(RateOfOwnTimes, IsFasterBy200PartsInAMillion) {
  RateWatch watch;
  std::mt19937_64 random{7};
  std::exponential_distribution<double> wait{1 / 0.0003};
  std::uniform_real_distribution<double> pause{0.05, 0.2};
  double own_s = 5000;
  const auto run = [&](double from_s, double to_s, double ppm) {
    for (double t = from_s; t < to_s;) {
      const double dt = pause(random);
      t += dt;
      own_s += dt * (1 + ppm * 1e-6);
      watch.add(at_s(t + wait(random)), from_seconds(own_s));
    }
  };
  run(0, 40, 25);
  EXPECT_FALSE(watch.change_ppm());
  run(40, 400, 25);
  EXPECT_FALSE(watch.change_ppm());
  run(400, 428, 225);
  ASSERT_TRUE(watch.change_ppm());
  EXPECT_NEAR(*watch.change_ppm(), 200, 20);
}

TEST_F(RateThatIsWatched, DidNotDriftWhenItsRasterJumped) {
  run(0, 40, 0);
  run(0, 12, 0);
  device_s += 0.002;
  for (int second = 0; second < 40; ++second) {
    run(0, 1, 0);
    EXPECT_FALSE(watch.change_ppm()) << second;
  }
}

}  // namespace drydock::diagnosis::clock_test
