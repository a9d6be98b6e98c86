#include "hil/characterize/timing.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hil/sensor/random.hpp"

namespace drydock::characterize {
namespace timing_test {

using measurement::from_seconds;
using measurement::Origin;
using measurement::stamp_from_ns;

Origin at(double arrival_s, double age_s) {
  Origin origin;
  origin.received_at = stamp_from_ns(1'700'000'000'000'000'000) + from_seconds(arrival_s);
  origin.valid_at = origin.received_at - from_seconds(age_s);
  return origin;
}

TEST(Timing, RateAndJitterComeBackWithinTheirBounds) {
  sensor::RandomStream random(1, "host", "jitter");
  constexpr double rate_hz = 100.02, jitter_s = 0.0005;
  std::vector<Origin> origins;
  for (int k = 0; k < 20'000; ++k)
    origins.push_back(at(k / rate_hz + jitter_s * random.normal(), 0.004));
  const auto timing = timing_of(origins).value();
  EXPECT_TRUE(timing.rate_hz.holds(rate_hz));
  EXPECT_LT(timing.rate_hz.high - timing.rate_hz.low, 2e-5 * rate_hz);
  EXPECT_NEAR(timing.jitter_s, jitter_s, 0.02 * jitter_s);
  EXPECT_GT(timing.largest_jitter_s, 3 * jitter_s);
  EXPECT_NEAR(timing.latency_s, 0.004, 1e-6);
  EXPECT_EQ(timing.outages, 0U);
  EXPECT_EQ(timing.outage_probability.low, 0);
}

TEST(Timing, MissingSamplesAreCountedAndDoNotSlowTheRate) {
  std::vector<Origin> origins;
  for (int k = 0; k < 1000; ++k)
    if (k % 100 != 50 && k != 351) origins.push_back(at(k * 0.1, 0));
  const auto timing = timing_of(origins).value();
  EXPECT_EQ(timing.outages, 10U);  // 350 and 351 are one outage
  EXPECT_EQ(timing.lost, 11U);
  EXPECT_NEAR(timing.rate_hz.value, 10, 1e-9);
  EXPECT_NEAR(timing.mean_outage, 1.1, 1e-12);
  EXPECT_TRUE(timing.outage_probability.holds(0.01));
}

// Half a period off the grid behind the pause, and one sample lost before it.
TEST(Timing, APauseIsNoOutageAndNoJitter) {
  std::vector<Origin> origins;
  for (int k = 0; k < 400; ++k)
    if (k != 50) origins.push_back(at(k * 2.03 + (k < 200 ? 0 : 4722.07), 0));
  const auto timing = timing_of(origins).value();
  EXPECT_EQ(timing.outages, 1U);
  EXPECT_EQ(timing.lost, 1U);
  EXPECT_NEAR(timing.mean_outage, 1, 1e-12);
  EXPECT_EQ(timing.pauses, 1U);
  EXPECT_NEAR(timing.paused_s, 4722.07 + 2.03, 1e-6);
  EXPECT_NEAR(timing.rate_hz.value, 1 / 2.03, 1e-9);
  EXPECT_LT(timing.largest_jitter_s, 1e-6);
}

// Two captures in one file, years apart: the clock jumps, the rate of the samples does not.
TEST(Timing, AClockThatJumpsByYearsIsNotAskedForTheRate) {
  std::vector<Origin> origins;
  for (int k = 0; k < 200; ++k) {
    origins.push_back(at(k * 0.5, 0));
    origins.back().device_time = from_seconds(k * 0.5 + (k < 100 ? 0 : 7e7));
  }
  const auto timing = timing_of(origins).value();
  EXPECT_NEAR(timing.rate_hz.value, 2, 1e-9);
  EXPECT_FALSE(timing.device_rate_hz);
  EXPECT_EQ(timing.lost, 0U);
  EXPECT_GE(timing.outage_probability.low, 0);
}

TEST(Timing, ADeviceClockThatIsSlowShowsAgainstTheHosts) {
  std::vector<Origin> origins;
  for (int k = 0; k < 1000; ++k) {
    origins.push_back(at(k * 0.010001, 0));
    origins.back().device_time = from_seconds(k * 0.01);
  }
  const auto timing = timing_of(origins).value();
  ASSERT_TRUE(timing.device_rate_hz);
  EXPECT_NEAR((timing.rate_hz.value / timing.device_rate_hz->value - 1) * 1e6, -100, 0.1);
}

TEST(Timing, OfTooFewSamplesOrOfOneInstantThereIsNone) {
  EXPECT_FALSE(timing_of({}));
  EXPECT_FALSE(timing_of(std::vector<Origin>(100, at(0, 0))));
}

}  // namespace timing_test
}  // namespace drydock::characterize
