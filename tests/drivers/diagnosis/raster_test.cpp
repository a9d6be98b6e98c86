#include "drivers/diagnosis/monitors/raster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "drivers/diagnosis/monitors/arrival_pattern.hpp"
#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::raster_test {

/// 5 Hz, learned.
struct FiveHertz : testing::Test {
  FiveHertz() {
    for (; now < 31; now += 0.2) raster.add(at_s(now));
  }
  Raster::Arrival add(double after_s) { return raster.add(at_s(now += after_s)); }

  Raster raster;
  double now = 0;
};

TEST_F(FiveHertz, IsKnownAfterHalfAMinute) {
  EXPECT_TRUE(raster.known());
  EXPECT_NEAR(raster.period_s(), 0.2, 1e-6);
  EXPECT_NEAR(raster.tolerance_s(), 0.01, 1e-6);  // a twentieth of a period
}

TEST_F(FiveHertz, NamesWhatComesOnItsPlace) {
  add(0);  // the place after the last that was learned
  EXPECT_EQ(add(0.2).step, Step::regular);
  const auto missing = add(0.6);
  EXPECT_EQ(missing.step, Step::missing);
  EXPECT_EQ(missing.slots, 3);
  EXPECT_EQ(add(0.13).step, Step::odd);
}

TEST_F(FiveHertz, MeasuresFromTheFirstOfACrowd) {
  add(0);
  EXPECT_EQ(add(0.01).step, Step::crowded);
  EXPECT_EQ(add(0.19).step, Step::regular);
}

TEST_F(FiveHertz, TakesAllThatWasHeldForACrowd) {
  add(0);
  EXPECT_EQ(add(1.0).step, Step::missing);
  for (int held = 0; held < 4; ++held) EXPECT_EQ(add(0.05).step, Step::crowded) << held;
  EXPECT_EQ(add(0.8).step, Step::missing) << "one second after the first of the crowd";
}

TEST(Raster, OfEventsAtRandomTimesIsNone) {
  Raster raster;
  std::mt19937_64 random(3);
  std::exponential_distribution<double> wait(5);
  for (double now = 0; now < 100; now += wait(random)) raster.add(at_s(now));
  EXPECT_FALSE(raster.known());
}

/// A fast packet of NMEA 2000 has up to 32 frames, one behind the other.
TEST(Raster, OfTheFramesOfOneLongMessageIsNone) {
  for (int frames = 2; frames <= 32; ++frames) {
    Raster raster(5);
    for (int i = 0; i < 200; ++i)
      for (int k = 0; k < frames; ++k) raster.add(at_s(0.2 * i + 0.00056 * k));
    EXPECT_FALSE(raster.known()) << frames;
  }
}

/// Messages at 5 Hz of which a share is lost, beside a rig that states some rate.
Raster with_lost(double share, double stated_hz) {
  Raster raster(stated_hz);
  std::mt19937_64 random(5);
  std::bernoulli_distribution lost(share);
  for (int i = 0; i < 200; ++i)
    if (!lost(random)) raster.add(at_s(0.2 * i));
  return raster;
}

/// Of messages that are each lost with the probability p, the share p is missing.
TEST(Raster, OfMessagesThatAreLostFromTheStartIsThatOfTheStatedRate) {
  for (const double share : {0.1, 0.3, 0.6}) {
    const Raster raster = with_lost(share, 5);
    ASSERT_TRUE(raster.known()) << share;
    EXPECT_NEAR(raster.period_s(), 0.2, 1e-6);
    EXPECT_NEAR(raster.missing_share(), share, 3 * std::sqrt(share * (1 - share) / 150));
    EXPECT_LT(raster.first_missing(), at_s(10));
  }
}

TEST(Raster, OfHalfTheStatedRateIsItsOwnAndNothingIsMissing) {
  Raster raster(10);
  for (int i = 0; i < 200; ++i) raster.add(at_s(0.2 * i));
  ASSERT_TRUE(raster.known());
  EXPECT_NEAR(raster.period_s(), 0.2, 1e-6);
  EXPECT_EQ(raster.missing_share(), 0);
}

TEST(Raster, OfAnUnevenStreamIsNoneWhateverRateIsStated) {
  for (const double stated_hz : {1.0, 5.0, 20.0}) {
    Raster raster(stated_hz);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> wait(0.1, 0.9);
    for (double now = 0; now < 100; now += wait(random)) raster.add(at_s(now));
    EXPECT_FALSE(raster.known()) << stated_hz;
  }
}

// Messages of 25 ms, one each 0.2 s, held until the next multiple of 1.08 s: five or six together.
TEST(Raster, SeesAllThatWasHeldComeTogether) {
  Raster raster;
  for (int i = 0; i < 200; ++i) raster.add(at_s(0.2 * i));
  ASSERT_TRUE(raster.known());
  long before = 0;
  double line_free = 0;
  for (int i = 201; i < 280; ++i) {
    const long release = std::lround(std::ceil(0.2 * i / 1.08));
    line_free = std::max(line_free, 1.08 * static_cast<double>(release)) + 0.025;
    const auto arrival = raster.add(at_s(line_free), 0.025);
    if (release == before) EXPECT_EQ(arrival.step, Step::crowded) << i;
    before = release;
  }
}

ArrivalPattern pattern_of(const std::vector<Raster::Arrival>& arrivals) {
  ArrivalPattern pattern;
  for (const auto& arrival : arrivals) pattern.add(arrival, 0.2);
  return pattern;
}

TEST(ArrivalPattern, OfMessagesThatWereHeldOneSecondIsBunched) {
  std::vector<Raster::Arrival> arrivals;
  for (int bunch = 0; bunch < 5; ++bunch) {
    arrivals.push_back({Step::missing, 1.0, 5});
    for (int i = 0; i < 4; ++i) arrivals.push_back({Step::crowded, 0.01, 0});
  }
  EXPECT_TRUE(pattern_of(arrivals).bunched());
}

// A message each 0.2 s, held until the next multiple of 0.28 s: two come together of each seven.
TEST(ArrivalPattern, OfMessagesThatWereHeldForLessThanTwoPeriodsIsBunchedAndNotSlower) {
  std::vector<Raster::Arrival> arrivals;
  for (int i = 0; i < 12; ++i) {
    arrivals.push_back({Step::odd, 0.28, 1});
    if (i % 5 == 1 || i % 5 == 4) arrivals.push_back({Step::crowded, 0.01, 0});
  }
  EXPECT_TRUE(pattern_of(arrivals).bunched());
  EXPECT_EQ(pattern_of(arrivals).slower(0.2), 1);
}

TEST(ArrivalPattern, WithRegularMessagesBetweenThePausesIsNotBunched) {
  std::vector<Raster::Arrival> arrivals;
  for (int i = 0; i < 8; ++i) {
    arrivals.push_back({Step::missing, 0.4, 2});
    arrivals.push_back({Step::crowded, 0.01, 0});
    arrivals.push_back({Step::regular, 0.2, 1});
  }
  EXPECT_FALSE(pattern_of(arrivals).bunched());
}

TEST(ArrivalPattern, OfHalfTheRateIsSlowerByTwo) {
  const std::vector<Raster::Arrival> arrivals(8, {Step::missing, 0.4, 2});
  EXPECT_NEAR(pattern_of(arrivals).slower(0.2), 2, 1e-9);
}

TEST(ArrivalPattern, WithLostMessagesIsNotSlower) {
  std::vector<Raster::Arrival> arrivals(8, {Step::missing, 0.4, 2});
  arrivals.push_back({Step::regular, 0.2, 1});
  EXPECT_EQ(pattern_of(arrivals).slower(0.2), 1);
}

}  // namespace drydock::diagnosis::raster_test
