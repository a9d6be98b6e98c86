// When a fault is in force: from its start until just before its end, and again in each of its
// turns.
#include <gtest/gtest.h>

#include "tests/hil/fault/faults.hpp"

namespace drydock::fault::test {
namespace {

FaultConfig timed(double start_s, std::optional<double> for_s, std::optional<double> every_s = {}) {
  FaultConfig fault = fault_of(FaultKind::hang);
  fault.start_s = start_s;
  fault.for_s = for_s;
  fault.every_s = every_s;
  return fault;
}

bool holds(const Schedule& schedule, std::chrono::nanoseconds after) {
  return !schedule.in_force(start + after).empty();
}

TEST(FaultSchedule, AFaultHoldsFromItsStartToJustBeforeItsEnd) {
  Schedule schedule(start);
  schedule.add(timed(10, 5));
  EXPECT_FALSE(holds(schedule, 10s - 1ns));
  EXPECT_TRUE(holds(schedule, 10s));
  EXPECT_TRUE(holds(schedule, 15s - 1ns));
  EXPECT_FALSE(holds(schedule, 15s));
  EXPECT_EQ(schedule.next_change(start), start + 10s);
  EXPECT_EQ(schedule.next_change(start + 10s), start + 15s);
  EXPECT_EQ(schedule.next_change(start + 15s), std::nullopt);
}

TEST(FaultSchedule, OneWithoutAnEndHoldsUntilItIsCleared) {
  Schedule schedule(start);
  schedule.add(timed(10, {}));
  EXPECT_TRUE(holds(schedule, 1'000'000s));
  EXPECT_EQ(schedule.next_change(start + 10s), std::nullopt);
  EXPECT_EQ(schedule.clear(FaultKind::drop), 0u) << "another kind";
  EXPECT_TRUE(holds(schedule, 20s));
  EXPECT_EQ(schedule.clear(FaultKind::hang), 1u);
  EXPECT_FALSE(holds(schedule, 20s));
}

TEST(FaultSchedule, OneThatComesAgainHoldsInEachOfItsTurns) {
  Schedule schedule(start);
  schedule.add(timed(1, 2, 10));
  for (int turn = 0; turn < 1000; ++turn) {
    const auto begins = 1s + turn * 10s;
    EXPECT_FALSE(holds(schedule, begins - 1ns));
    EXPECT_TRUE(holds(schedule, begins));
    EXPECT_EQ(schedule.in_force(start + begins)[0].since, start + begins);
    EXPECT_EQ(schedule.next_change(start + begins), start + begins + 2s);
    EXPECT_FALSE(holds(schedule, begins + 2s));
    EXPECT_EQ(schedule.next_change(start + begins + 2s), start + begins + 10s);
  }
}

TEST(FaultSchedule, WhatIsSetByHandHoldsFromThatMomentForItsTime) {
  Schedule schedule(start);
  const auto before = schedule.edits();
  schedule.set(timed(0, 5), start + 42s);
  EXPECT_NE(schedule.edits(), before) << "who follows it must look again";
  EXPECT_TRUE(holds(schedule, 42s));
  EXPECT_FALSE(holds(schedule, 47s));
}

TEST(FaultSchedule, AMonthOfFaultsSetByHandIsNotKept) {
  Schedule schedule(start);
  FaultConfig of_a_file = timed(0, 1);
  of_a_file.file = "rig.toml";
  schedule.add(of_a_file);
  for (int hour = 0; hour < 720; ++hour) {
    FaultConfig fault = fault_of(hour % 2 == 0 ? FaultKind::drop : FaultKind::flip);
    fault.for_s = 60;
    schedule.set(fault, start + std::chrono::hours{hour});
    EXPECT_EQ(schedule.size(), 2u) << "the one of the file, and the one that holds";
  }
}

TEST(FaultSchedule, ManyHoldTogetherInTheOrderInWhichTheyWereWritten) {
  Schedule schedule(start);
  schedule.add(timed(0, 100));
  schedule.add(timed(10, {}));
  const auto now = schedule.in_force(start + 20s);
  ASSERT_EQ(now.size(), 2u);
  EXPECT_EQ(now[0].until, start + 100s);
  EXPECT_EQ(now[1].until, std::nullopt);
}

}  // namespace
}  // namespace drydock::fault::test
