#include "drivers/device/shared_times.hpp"

#include <gmock/gmock.h>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {
namespace shared_times_test {

using measurement::MessageTimes;
using testing::ElementsAre;
using namespace std::chrono_literals;

std::vector<double> seconds_of(const MessageTimes& times) {
  std::vector<double> seconds;
  for (const auto& message : times) seconds.push_back(measurement::seconds(message.at));
  return seconds;
}

TEST(SharedTimes, WhatSeveralDevicesSayBetweenTwoMessagesOfTheClockIsOneBurst) {
  const MessageTimes clock{{100, 10s}, {200, 11s}, {300, 21s}};
  EXPECT_THAT(seconds_of(times_at(clock, {{120, 220, 300}, {130, 160, 190, 250}})),
              ElementsAre(10, 11, 21));
}

TEST(SharedTimes, TheMessagesOfAFasterDeviceComeAtEvenDistances) {
  const MessageTimes clock{{100, 10s}, {200, 11s}};
  const auto times = times_at(clock, {{110, 120, 130, 140, 190}, {150}});
  EXPECT_THAT(seconds_of(times), ElementsAre(10, 10.2, 10.4, 10.6, 10.8, 11));
  EXPECT_EQ(times[1].through, 110u);
  EXPECT_EQ(times[4].through, 140u);
}

/// The mean is 2 s for 100 places.
TEST(SharedTimes, BehindTheClockTimeGoesOnAtItsMeanRate) {
  const MessageTimes clock{{100, 10s}, {150, 10s}, {300, 14s}};
  EXPECT_THAT(seconds_of(times_at(clock, {{310, 320, 400, 500}})),
              ElementsAre(10, 10, 14, 15, 16, 17, 18));
}

}  // namespace shared_times_test
}  // namespace drydock::device
