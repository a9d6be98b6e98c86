#include "drivers/diagnosis/monitors/time_monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::time_monitor_test {

/// A device without a clock at 10 Hz, whose raster is known.
struct TenHertz : testing::Test {
  TenHertz() {
    for (int i = 0; i < 400; ++i) regular();
  }
  void regular() { come(now += 0.1); }
  void come(double at, bool same = false) {
    measurement::Origin origin;
    origin.received_at = origin.valid_at = at_s(at);
    monitor.take(1, origin, same);
    monitor.look(at_s(at));
  }
  Signs signs;
  TimeMonitor monitor{{.kind = measurement::Kind::depth, .nominal_rate_hz = 10}, signs};
  double now = 0;
};

TEST_F(TenHertz, HasNoSignInADay) {
  for (int i = 0; i < 864'000; ++i) regular();
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(TenHertz, HasNoSignForOneLostMessageInAThousand) {
  for (int i = 0; i < 20'000; ++i) {
    if (i % 1000 == 0) now += 0.1;
    regular();
  }
  EXPECT_FALSE(signs.has(Sign::gaps));
}

// Three gaps of ln(500) each, less 0.05 for each message between them: 18 within 12 messages.
TEST_F(TenHertz, HasGapsAfterTheThirdLostMessage) {
  for (int lost = 0; lost < 3; ++lost) {
    EXPECT_FALSE(signs.has(Sign::gaps));
    now += 0.1;
    for (int i = 0; i < 4; ++i) regular();
  }
  now += 0.1;
  regular();
  EXPECT_TRUE(signs.has(Sign::gaps));
  EXPECT_FALSE(signs.has(Sign::irregular));
}

TEST_F(TenHertz, RepeatsMessages) {
  for (int i = 0; i < 20; ++i) {
    regular();
    if (i % 4 == 0) come(now + 0.001, true);
  }
  EXPECT_TRUE(signs.has(Sign::repeated));
  EXPECT_FALSE(signs.has(Sign::swapped));
  EXPECT_FALSE(signs.has(Sign::gaps));
}

TEST_F(TenHertz, SwapsMessages) {
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 3; ++k) regular();
    now += 0.1;  // this one comes behind the next
    regular();
    come(now + 0.001);
  }
  EXPECT_TRUE(signs.has(Sign::swapped));
  EXPECT_FALSE(signs.has(Sign::gaps));
  EXPECT_FALSE(signs.has(Sign::repeated));
}

TEST_F(TenHertz, IsIrregularWhenMessagesAreLateAtRandom) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> late(0, 0.05);
  for (int i = 0; i < 20; ++i) come((now += 0.1) + late(random));
  EXPECT_TRUE(signs.has(Sign::irregular));
}

TEST_F(TenHertz, IsSlowWhenEverySecondMessageComes) {
  for (int i = 0; i < 12; ++i) come(now += 0.2);
  ASSERT_TRUE(signs.has(Sign::rate_low));
  EXPECT_NEAR(signs.first(Sign::rate_low).value, 5, 1e-6);   // Hz
  EXPECT_NEAR(signs.first(Sign::rate_low).limit, 10, 1e-6);  // Hz
}

/// One message in 1.5, 1.93 or 2.74: whole periods that follow a line.
TEST_F(TenHertz, IsSlowWhenAFractionOfTheMessagesComes) {
  for (const double times : {1.5, 1.93, 2.74}) {
    for (int i = 0; i < 300; ++i) regular();
    signs.all.clear();
    const double from = now;
    for (int i = 1; i <= 24; ++i) come(now = from + std::floor(i * times) / 10);
    ASSERT_TRUE(signs.has(Sign::rate_low)) << times;
    std::erase_if(signs.all, [](const Symptom& one) { return one.sign != Sign::rate_low; });
    EXPECT_NEAR(signs.all.back().value, 10 / times, 0.3) << times;
  }
}

/// Each message comes with the probability 0.4 to 0.9.
TEST_F(TenHertz, IsNotSlowWhenMessagesAreLostAtRandom) {
  std::mt19937_64 random(1);
  int slow = 0, looks = 0;
  for (const double share : {0.4, 0.6, 0.8, 0.9}) {
    std::bernoulli_distribution comes(share);
    for (int i = 0; i < 20'000; ++i) {
      now += 0.1;
      if (!comes(random)) continue;
      signs.all.clear();
      come(now);
      ++looks;
      slow += signs.has(Sign::rate_low) ? 1 : 0;
    }
  }
  EXPECT_LT(slow, looks / 1000) << "of " << looks;
}

TEST_F(TenHertz, IsLateByTheHoleInItsRaster) {
  now += 0.5;
  for (int i = 0; i < 8; ++i) regular();
  ASSERT_TRUE(signs.has(Sign::late));
  EXPECT_NEAR(signs.first(Sign::late).value, 0.5, 1e-6);
  EXPECT_FALSE(signs.has(Sign::gaps));
}

TEST_F(TenHertz, HasNoSignWhenItsHostStoodStill) {
  monitor.interrupt();
  now += 0.7;
  for (int i = 0; i < 100; ++i) regular();
  EXPECT_TRUE(signs.all.empty());
}

/// A DVL at 5 Hz, as its rig states, for two minutes from its first message on.
Signs from_the_start(const std::function<std::optional<double>(int)>& arrives_s) {
  Signs signs;
  TimeMonitor monitor({.kind = measurement::Kind::dvl, .nominal_rate_hz = 5}, signs);
  for (int i = 0; i < 600; ++i) {
    const auto at = arrives_s(i);
    if (!at) continue;
    measurement::Origin origin;
    origin.received_at = origin.valid_at = at_s(*at);
    monitor.take(1, origin, false);
    monitor.look(at_s(*at));
  }
  return signs;
}

TEST(FromTheStart, LostMessagesAreGapsSinceTheFirstOfThem) {
  std::mt19937_64 random(4);
  std::bernoulli_distribution lost(0.3);
  const Signs signs =
      from_the_start([&](int i) { return lost(random) ? std::nullopt : std::optional(0.2 * i); });
  ASSERT_TRUE(signs.has(Sign::gaps));
  EXPECT_LT(signs.first(Sign::gaps).since, at_s(5));
  EXPECT_FALSE(signs.has(Sign::irregular));
}

/// The interval between two messages that are late by up to a varies by a / sqrt(6).
TEST(FromTheStart, RandomDelaysAreIrregular) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> late(0, 0.1);
  const Signs signs = from_the_start([&](int i) { return std::optional(0.2 * i + late(random)); });
  ASSERT_TRUE(signs.has(Sign::irregular));
  EXPECT_LT(signs.first(Sign::irregular).since, at_s(0.2));
  EXPECT_NEAR(signs.first(Sign::irregular).value, 0.1 / std::sqrt(6.0), 0.004);
}

/// A head that pings when its last echo is back: each interval by itself, with the stated mean.
TEST(FromTheStart, AHeadThatPingsUnevenlyIsSound) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> wait(0.1, 0.3);
  double now = 0;
  const Signs signs = from_the_start([&](int) { return std::optional(now += wait(random)); });
  EXPECT_TRUE(signs.all.empty());
}

TEST(FromTheStart, ABusyHostIsSound) {
  std::mt19937_64 random(4);
  std::exponential_distribution<double> late(1 / 0.004);
  const Signs signs = from_the_start([&](int i) { return std::optional(0.2 * i + late(random)); });
  EXPECT_FALSE(signs.has(Sign::irregular));
  EXPECT_FALSE(signs.has(Sign::gaps));
}

/// A log at 1 Hz on a line of 4800 baud: 480 characters a second. Its sentences have as many as its
/// numbers need, and its values were true when their sentence began.
struct LogOnALine : testing::Test {
  LogOnALine() { for_seconds(60, 35, 0); }
  void for_seconds(int seconds, int characters, double begins_s) {
    for (int i = 0; i < seconds; ++i) {
      measurement::Origin origin;
      origin.valid_at = at_s((now += 1) + begins_s);
      origin.received_at = origin.valid_at + measurement::from_seconds(characters / 480.0);
      monitor.take(1, origin, false);
      monitor.look(origin.received_at);
    }
  }
  Signs signs;
  TimeMonitor monitor{
      {.kind = measurement::Kind::emlog, .nominal_rate_hz = 1, .line_bytes_per_second = 480},
      signs};
  double now = 0;
};

TEST_F(LogOnALine, HasNoClockThatDriftsWhereItsNumbersBecomeLonger) {
  for (int characters = 35; characters < 45; ++characters) for_seconds(4, characters, 0);
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(LogOnALine, DriftsWhereItsSentencesBeginLaterAndLater) {
  for (int second = 0; second < 60; ++second) for_seconds(1, 35 + second % 3, 1e-3 * second);
  ASSERT_TRUE(signs.has(Sign::clock_drift));
  EXPECT_NEAR(signs.all.back().value, -1000, 10);
}

}  // namespace drydock::diagnosis::time_monitor_test
