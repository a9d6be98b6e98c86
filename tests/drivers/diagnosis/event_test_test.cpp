#include "drivers/diagnosis/monitors/event_test.hpp"

#include <gtest/gtest.h>

#include <random>

namespace drydock::diagnosis::event_test_test {

// ln(0.05 / 0.0001) = 6.2146: two events are 12.4, three are 18.6.
TEST(EventTest, OfOneIn10000AgainstOneIn20FiresAtTheThirdEvent) {
  EventTest test(1e-4, 0.05, 18);
  test.add(true, Stamp{});
  test.add(true, Stamp{});
  EXPECT_NEAR(test.sum(), 12.429, 0.001);
  EXPECT_FALSE(test.fired());
  test.add(true, Stamp{});
  EXPECT_TRUE(test.fired());
}

// ln(0.9999 / 0.95) = 0.05119 for each sample without an event.
TEST(EventTest, ForgetsAnEventAfter122SamplesWithoutOne) {
  EventTest test(1e-4, 0.05, 18);
  test.add(true, Stamp{});
  for (int i = 0; i < 121; ++i) test.add(false, Stamp{});
  EXPECT_GT(test.sum(), 0);
  test.add(false, Stamp{});
  EXPECT_EQ(test.sum(), 0);
}

double mean_run(double share, double usual, double raised, double threshold, int runs) {
  std::mt19937_64 random(7);
  std::bernoulli_distribution event(share);
  double samples = 0;
  for (int run = 0; run < runs; ++run) {
    EventTest test(usual, raised, threshold);
    while (!test.fired()) {
      test.add(event(random), Stamp{});
      ++samples;
    }
  }
  return samples / runs;
}

// Lorden 1971: at least exp(h) samples to a false alarm.
TEST(EventTest, GivesHealthySamplesTheirRunToAFalseAlarm) {
  EXPECT_GT(mean_run(0.02, 0.02, 0.5, 5, 400), std::exp(5.0));
}

// Wald's identity: the mean delay lies between h / I and (h + gain) / I with the information
// I = 0.5 ln(0.5/0.02) + 0.5 ln(0.5/0.98) = 1.273 a sample.
TEST(EventTest, FindsWhatItIsMadeForAfterTheDelayOfTheory) {
  const double information = 0.5 * std::log(0.5 / 0.02) + 0.5 * std::log(0.5 / 0.98);
  const double delay = mean_run(0.5, 0.02, 0.5, 18, 4000);
  EXPECT_GT(delay, 18 / information * 0.97);
  EXPECT_LT(delay, (18 + std::log(25)) / information);
}

TEST(EventTest, SaysWhenItBegan) {
  EventTest test(1e-4, 0.05, 18);
  test.add(false, Stamp{std::chrono::seconds{1}});
  test.add(true, Stamp{std::chrono::seconds{2}});
  test.add(true, Stamp{std::chrono::seconds{3}});
  test.add(true, Stamp{std::chrono::seconds{4}});
  EXPECT_EQ(test.since(), Stamp{std::chrono::seconds{2}});
}

}  // namespace drydock::diagnosis::event_test_test
