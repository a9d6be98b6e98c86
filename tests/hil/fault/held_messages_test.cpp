// Messages that come later: by a constant or random time, or together. The order stays and none is
// lost.
#include "hil/fault/wire/held_messages.hpp"

#include <gtest/gtest.h>

#include "tests/hil/fault/faults.hpp"

namespace drydock::fault::test {
namespace held_messages_test {

struct Arrival {
  std::uint8_t number;
  Stamp at;
};

/// Message i is sent at start + i x 100 ms. Returns the arrival of each.
std::vector<Arrival> arrivals(const std::vector<FaultConfig>& faults, int count = 100) {
  HeldMessages<Message> held(1, "dvl");
  held.set(in_force(faults));
  std::vector<Arrival> all;
  const auto take_until = [&](Stamp now) {
    for (auto due = held.deadline(); due && *due <= now; due = held.deadline()) {
      const Stamp at = *due;
      EXPECT_FALSE(held.take(at - 1ns));
      all.push_back({held.take(at)->front(), at});
    }
  };
  for (int i = 0; i < count; ++i) {
    take_until(start + i * 100ms);
    held.put({static_cast<std::uint8_t>(i)}, start + i * 100ms);
  }
  take_until(start + 1h);
  return all;
}

TEST(HeldMessages, WithoutAFaultTheyComeAtOnce) {
  for (const auto& [number, at] : arrivals({})) EXPECT_EQ(at, start + number * 100ms);
}

TEST(HeldMessages, ADelayMovesEachByTheSame) {
  const auto all = arrivals({fault_of(FaultKind::delay, 0.75)});
  ASSERT_EQ(all.size(), 100u);
  for (const auto& [number, at] : all) EXPECT_EQ(at, start + number * 100ms + 750ms);
}

TEST(HeldMessages, JitterIsBetweenNothingAndItsBoundAndKeepsTheOrder) {
  const auto all = arrivals({fault_of(FaultKind::jitter, 0.05)});
  double sum_ms = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(all[i].number, i);
    const auto late = all[i].at - (start + all[i].number * 100ms);
    ASSERT_GE(late, 0ms);
    ASSERT_LT(late, 50ms);
    sum_ms += measurement::seconds(late) * 1e3;
  }
  // Uniform: mean 25 ms; the mean of 100 has a standard deviation of 1.44 ms.
  EXPECT_NEAR(sum_ms / 100, 25, 6);
}

TEST(HeldMessages, JitterAboveTheIntervalStillKeepsTheOrder) {
  const auto all = arrivals({fault_of(FaultKind::jitter, 1)});
  ASSERT_EQ(all.size(), 100u);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_EQ(all[i].number, all[i - 1].number + 1);
    EXPECT_GE(all[i].at, all[i - 1].at);
  }
}

TEST(HeldMessages, ABurstBringsAllOfItsTimeTogether) {
  const auto all = arrivals({fault_of(FaultKind::burst, 1)});
  ASSERT_EQ(all.size(), 100u);
  for (const auto& [number, at] : all) EXPECT_EQ(at, start + (number / 10 + 1) * 1s);
}

TEST(HeldMessages, WhatWaitsWhenTheDelayEndsComesAtItsTimeAndWhatFollowsAfterIt) {
  HeldMessages<Message> held(1, "dvl");
  const std::vector<FaultConfig> delay{fault_of(FaultKind::delay, 2)};
  held.set(in_force(delay));
  held.put({1}, start);
  held.set({});
  held.put({2}, start + 1s);
  EXPECT_EQ(held.deadline(), start + 2s);
  EXPECT_EQ(held.take(start + 2s), Message{1});
  EXPECT_EQ(held.take(start + 2s), Message{2});
  EXPECT_EQ(held.deadline(), std::nullopt);
}

}  // namespace held_messages_test
}  // namespace drydock::fault::test
