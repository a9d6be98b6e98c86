#include "drivers/diagnosis/monitors/quantity_monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "drivers/diagnosis/monitors/sameness.hpp"
#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::quantity_monitor_test {

/// A DVL at 5 Hz: white noise of 0.1 m/s on a slow swing of 1 m/s.
struct BottomVelocityThatIsWatched : testing::Test {
  BottomVelocityThatIsWatched() {
    while (now < 50) add(sigma);
  }
  QuantityMonitor::News add(double deviation, double off = 0) {
    now += 0.2;
    const double truth = std::sin(now / 5);
    return monitor.add(truth + off + deviation * normal(random), at_s(now));
  }
  static constexpr double sigma = 0.1;
  QuantityMonitor monitor{Quantity::bottom_x};
  std::mt19937_64 random{11};
  std::normal_distribution<double> normal;
  double now = 0;
};

// The deviation of x0 - 2 x1 + x2 is sqrt(1 + 4 + 1) of the noise; 240 of them give it within 15 %.
TEST_F(BottomVelocityThatIsWatched, HasTheScatterOfItsSecondDifferences) {
  EXPECT_TRUE(monitor.known());
  EXPECT_TRUE(monitor.noise_shows());
  EXPECT_NEAR(monitor.sigma(), std::sqrt(6) * sigma, 0.15 * std::sqrt(6) * sigma);
}

TEST_F(BottomVelocityThatIsWatched, IsHealthyForADay) {
  for (int i = 0; i < 5 * 86400; ++i) {
    const auto news = add(sigma);
    ASSERT_EQ(news.wild, 0);
    ASSERT_EQ(news.jump, 0);
    ASSERT_FALSE(news.noisy);
  }
}

// 76 % of second differences of noise ten times as strong lie beyond three usual deviations: 2.3 of
// 22 a sample, so 10 samples; half as much again for the correlation of second differences.
TEST_F(BottomVelocityThatIsWatched, IsNoisyWithinTwentyFourSamplesOfTenfoldNoise) {
  int samples = 0;
  while (!add(10 * sigma).noisy) ASSERT_LT(++samples, 24);
  EXPECT_GE(samples, 6);  // 22 / ln(25) = 6.8 events at least
}

/// Noise of a DVL whose grade is 0.01 m/s, in steps of 1 mm/s, from the first sample on.
bool is_noisy_from_the_start(double deviation, double grade) {
  QuantityMonitor monitor(Quantity::bottom_x, grade);
  std::mt19937_64 random{11};
  std::normal_distribution<double> normal;
  for (double now = 0; now < 60; now += 0.2) {
    const double read = std::sin(now / 5) + deviation * normal(random);
    if (!monitor.add(1e-3 * std::round(1e3 * read), at_s(now)).noisy) continue;
    EXPECT_LT(monitor.noise().since(), at_s(1));
    return true;
  }
  return false;
}

TEST(QuantityMonitor, IsNoisyFromTheStartBesideItsGradeOnly) {
  EXPECT_TRUE(is_noisy_from_the_start(0.1, 0.01));
  EXPECT_FALSE(is_noisy_from_the_start(0.02, 0.01)) << "data sheets are of the best case";
  EXPECT_FALSE(is_noisy_from_the_start(0.1, 0)) << "nobody said a grade";
}

// In the first 45 s of a receiver are 45 samples. Of three hundred sets of them one scatters by a
// third less than all: a chi-square variable with 25 degrees, for second differences are not
// independent.
TEST(QuantityMonitor, IsNotNoisyBecauseItsFewFirstSamplesHappenedToScatterLittle) {
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    QuantityMonitor monitor(Quantity::north);
    std::mt19937_64 random{seed};
    std::normal_distribution<double> normal{0, 1.5};
    for (double now = 0; now < 12 * 3600; now += 1) {
      const double scatters = now < 46 ? 0.63 : 1;
      if (monitor.add(scatters * normal(random), at_s(now)).noisy) ++alarms;
    }
  }
  EXPECT_EQ(alarms, 0);
}

TEST(QuantityMonitor, TakesTheStepsOfASensorForNoNoise) {
  QuantityMonitor monitor(Quantity::bottom_x, 0.002);
  std::mt19937_64 random{11};
  std::normal_distribution<double> normal;
  for (double now = 0; now < 60; now += 0.2) {
    const double read = std::sin(now / 5) + 0.002 * normal(random);
    EXPECT_FALSE(monitor.add(0.05 * std::round(read / 0.05), at_s(now)).noisy) << now;
  }
}

TEST_F(BottomVelocityThatIsWatched, HasAWildSampleThatTheNextOneShows) {
  EXPECT_EQ(add(0, 5).wild, 0);
  EXPECT_NEAR(add(0).wild, 5, 0.2);
}

TEST_F(BottomVelocityThatIsWatched, IsNotNoisyForOneWildSampleInTen) {
  for (int i = 1; i < 1000; ++i) {
    ASSERT_FALSE(add(sigma, i % 10 == 0 ? 5 : 0).noisy) << i;
  }
}

/// A vehicle that begins to speed up: the second differences rise and fall like a sine in 25
/// samples, up to ten deviations.
TEST_F(BottomVelocityThatIsWatched, IsNotNoisyForAMotionThatBegins) {
  double speed = 0, slope = 0;
  for (int motion = 0; motion < 20; ++motion)
    for (int i = 0; i < 25; ++i) {
      slope += 10 * std::sqrt(6) * sigma * std::sin(2 * 3.14159265 * i / 25);
      speed += slope;
      ASSERT_FALSE(add(sigma, speed).noisy) << motion << " " << i;
    }
}

TEST_F(BottomVelocityThatIsWatched, StepsAndStays) {
  add(0);
  add(0);
  add(0, 3);
  const auto news = add(0, 3);
  EXPECT_NEAR(news.jump, 3, 0.2);
  EXPECT_LT(news.most, news.jump);
}

// A sounding rocket: 97 m/s to the north, positions at 10 Hz with 1.5 m of noise, ten minutes.
TEST(QuantityMonitor, OfAFastVehicleSeesAStepBeyondItsWayAndNoOther) {
  QuantityMonitor monitor{Quantity::north};
  std::mt19937_64 random{5};
  std::normal_distribution<double> normal{0, 1.5};
  for (int i = 0; i < 6000; ++i)
    ASSERT_EQ(monitor.add(9.7 * i + normal(random), at_s(0.1 * i)).jump, 0) << i;
  double jump = 0;
  for (int i = 6000; i < 6003; ++i)
    jump += monitor.add(9.7 * i + 60 + normal(random), at_s(0.1 * i)).jump;
  EXPECT_NEAR(jump, 60, 6);
}

TEST(QuantityMonitor, OfAHeadingDoesNotStepAtNorth) {
  QuantityMonitor monitor(Quantity::heading);
  constexpr double circle = 2 * std::numbers::pi;
  for (int i = 0; i < 3000; ++i) {
    const auto news = monitor.add(std::fmod(i * 0.05, circle), at_s(i * 0.1));
    ASSERT_EQ(news.wild, 0) << i;
    ASSERT_EQ(news.jump, 0) << i;
  }
}

Readings one(double value) { return {{Quantity::bottom_x, value}}; }

// All 225 messages of the first time differ: the share is at most 1/31 in a window of thirty, and
// (1/31)^7 is the first power below 1e-10.
TEST(Sameness, OfSevenEqualMessagesIsImpossibleWhereNoneWereEqual) {
  Sameness sameness;
  for (int i = 0; i < 240; ++i) sameness.add(one(i), at_s(i * 0.2));
  ASSERT_TRUE(sameness.impossible_run());
  EXPECT_EQ(*sameness.impossible_run(), 7U);
  for (int i = 0; i < 8; ++i) sameness.add(one(-1), at_s(48 + i * 0.2));
  EXPECT_EQ(sameness.run(), 7U);
}

TEST(Sameness, SaysNothingWhereEqualMessagesAreUsual) {
  Sameness sameness;
  for (int i = 0; i < 480; ++i) sameness.add(one(i / 10), at_s(i * 0.1));
  EXPECT_FALSE(sameness.impossible_run());
}

TEST(Sameness, SaysNothingOfASensorThatStoodStillForAWhile) {
  Sameness sameness;
  for (int i = 0; i < 480; ++i) sameness.add(one(i < 100 ? 0 : i), at_s(i * 0.1));
  EXPECT_FALSE(sameness.impossible_run());
}

/// 3 m/s to the east, a fix a second, and none for 20 s: when the receiver is still learned, and
/// later.
TEST(PositionThatIsWatched, OfADiveWithoutAFixIsNoJumpWheneverItIs) {
  for (const int lost_at : {20, 40, 46, 60, 200}) {
    QuantityMonitor monitor{Quantity::east};
    for (int i = 0; i < 300; ++i) {
      if (i > lost_at && i < lost_at + 21) continue;
      EXPECT_EQ(monitor.add(3.0 * i, at_s(i)).jump, 0) << lost_at << " " << i;
    }
  }
}

/// Three seconds of a fast boat at 19 m/s are 57 m, and a step of 20 m in a second is none of it.
TEST(PositionThatIsWatched, MayMoveForAsLongAsAFixIsLate) {
  for (const int lost : {0, 2}) {
    QuantityMonitor monitor{Quantity::east};
    double at = 0, jump = 0;
    for (int i = 0; i < 120; ++i) jump += monitor.add(at += 3, at_s(i)).jump;
    at += 3 + 19 * (1 + lost);
    for (int i = 120 + lost; i < 140; ++i) jump += monitor.add(at += 3, at_s(i)).jump;
    EXPECT_EQ(jump, 0) << lost;
  }
}

}  // namespace drydock::diagnosis::quantity_monitor_test
