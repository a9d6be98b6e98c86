#include "drivers/device/clock_reader.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace drydock::device {
namespace clock_reader_test {

using measurement::MessageTimes;
using namespace std::chrono_literals;

/// Messages of 100 bytes with these times.
RecordedTimes in_order(const std::vector<std::chrono::nanoseconds>& told) {
  MessageTimes times;
  for (const auto at : told) times.push_back({100 * (times.size() + 1), at});
  return times_in_order(times);
}

std::vector<double> seconds_of(const RecordedTimes& times) {
  std::vector<double> seconds;
  for (const auto& message : times.messages) seconds.push_back(measurement::seconds(message.at));
  return seconds;
}

TEST(ClockReader, APauseOfTheDeviceStaysAPause) {
  EXPECT_EQ(seconds_of(in_order({10s, 12s, 3612s, 3614s})),
            (std::vector<double>{10, 12, 3612, 3614}));
}

TEST(ClockReader, ATimeOfDayAndATimeOfWeekBeginAnew) {
  const auto day = in_order({86398s, 86399s, 0s, 1s});
  EXPECT_EQ(seconds_of(day), (std::vector<double>{86398, 86399, 86400, 86401}));
  const auto week = in_order({604799s, 0s, 1s});
  EXPECT_EQ(seconds_of(week), (std::vector<double>{604799, 604800, 604801}));
  EXPECT_EQ(day.jumps + week.jumps, 0u);
}

TEST(ClockReader, AClockThatIsSetBackGoesOnByAUsualStepAndIsCounted) {
  std::vector<std::chrono::nanoseconds> told;
  for (int i = 0; i < 20; ++i) told.push_back(std::chrono::seconds{1000 + 2 * i});
  for (int i = 0; i < 20; ++i) told.push_back(std::chrono::seconds{500 + 2 * i});
  const auto times = in_order(told);
  EXPECT_EQ(times.jumps, 1u);
  EXPECT_EQ(times.usual_step, 2s);
  EXPECT_EQ(seconds_of(times)[20], 1040);
  EXPECT_EQ(seconds_of(times).back(), 1078);
}

TEST(ClockReader, OneWrongDateMovesNothingBehindIt) {
  std::vector<std::chrono::nanoseconds> told;
  for (int i = 0; i < 30; ++i) told.push_back(std::chrono::seconds{1000 + i});
  told[15] += 24h * 3650;
  const auto times = in_order(told);
  EXPECT_EQ(times.jumps, 2u);
  EXPECT_EQ(seconds_of(times).back(), 1029);
}

/// A Magellan 315 tells 120827.523 in its GLL, and 120827.52 in the sentences behind it.
TEST(ClockReader, ATimeThatIsCutShorterIsNoJump) {
  std::vector<std::chrono::nanoseconds> told;
  for (int i = 0; i < 50; ++i) {
    told.push_back(2s * i + 23ms);
    told.push_back(2s * i + 20ms);
  }
  const auto times = in_order(told);
  EXPECT_EQ(times.jumps, 0u);
  ASSERT_EQ(times.messages.size(), told.size());
  for (std::size_t i = 0; i < told.size(); ++i)
    EXPECT_EQ(times.messages[i].at, 2s * (i / 2) + 23ms);
}

TEST(ClockReader, AClockThatStandsOrFallsAsOftenAsItRisesIsNone) {
  EXPECT_TRUE(in_order({5s, 5s, 5s, 5s}).messages.empty());
  EXPECT_TRUE(in_order({5s, 9s, 2s, 7s, 1s, 8s}).messages.empty());
  EXPECT_TRUE(in_order({}).messages.empty());
}

}  // namespace clock_reader_test
}  // namespace drydock::device
