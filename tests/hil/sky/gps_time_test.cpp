#include "hil/sky/gps_time.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace drydock::sky {
namespace gps_time_test {

using namespace std::chrono;
using measurement::Stamp;

Stamp utc(sys_days day, nanoseconds of_day = {}) { return Stamp{day.time_since_epoch() + of_day}; }

TEST(GpsTime, BeganOnTheSixthOfJanuary1980) {
  EXPECT_EQ(gps_time(utc(1980y / January / 6)), GpsTime{});
}

TEST(GpsTime, IsAheadOfUtcByTheLeapSecondsOfTheDay) {
  // The headers of broadcast files of these days have 13, 15 and 16.
  EXPECT_EQ(gps_ahead_of_utc(utc(2005y / April / 2)), 13s);
  EXPECT_EQ(gps_ahead_of_utc(utc(2010y / July / 1)), 15s);
  EXPECT_EQ(gps_ahead_of_utc(utc(2012y / October / 31)), 16s);
  EXPECT_EQ(gps_ahead_of_utc(utc(2016y / December / 31, 24h - 1ns)), 17s);
  EXPECT_EQ(gps_ahead_of_utc(utc(2017y / January / 1)), 18s);
}

TEST(GpsTime, WeekAndSecondAreThoseOfTheIgsFileOfThatDay) {
  // Second line of igs15904.sp3: 2010-07-01T00:00 is week 1590, second 345600.
  const GpsWeek week = week_of(gps_time(sys_days{2010y / July / 1}, 0s));
  EXPECT_EQ(week.week, 1590);
  EXPECT_EQ(week.of_week, 345600s);
}

RC_GTEST_PROP(GpsTime, ThereAndBackIsTheSameInstant, ()) {
  const auto ns = *rc::gen::inRange<std::int64_t>(320'000'000, 2'000'000'000) * 1'000'000'000 + 7;
  const Stamp at = measurement::stamp_from_ns(ns);
  RC_ASSERT(utc_time(gps_time(at)) == at);
}

TEST(GpsTime, ThereAndBackHoldsOnBothSidesOfALeapSecond) {
  for (const auto offset : {-20s, -18s, -1s, 0s, 1s, 18s}) {
    const Stamp at = utc(2017y / January / 1, offset);
    EXPECT_EQ(utc_time(gps_time(at)), at) << offset.count();
  }
}

}  // namespace gps_time_test
}  // namespace drydock::sky
