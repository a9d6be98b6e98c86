#include "drivers/capture/arrival_times.hpp"

#include <gtest/gtest.h>

namespace drydock::capture {
namespace {

using namespace std::chrono_literals;

/// 200 frames of 8 bytes, this far apart. At 1 Mbit/s such a frame takes at least 131 us
/// (ISO 11898-1: 131 bits without a stuff bit).
ArrivalTimes of_frames(std::optional<std::chrono::nanoseconds> apart) {
  ArrivalTimes arrivals;
  for (int i = 0; i < 200; ++i) {
    Record record;
    if (apart) record.time = 1000s + i * *apart;
    record.frame.extended = true;
    record.frame.size = 8;
    arrivals.add(record);
  }
  return arrivals;
}

TEST(ArrivalTimes, FramesAsFastAsABusCarriesThemHaveTimes) {
  EXPECT_TRUE(of_frames(131us).are_told());
  EXPECT_TRUE(of_frames(10ms).are_told());
  EXPECT_EQ(of_frames(10ms).first(), 1000s);
}

TEST(ArrivalTimes, FramesFasterThanAnyBusHaveNone) {
  EXPECT_FALSE(of_frames(3us).are_told());
  EXPECT_FALSE(of_frames(0us).are_told());
}

TEST(ArrivalTimes, AFormatWithoutTimesHasNone) {
  EXPECT_FALSE(of_frames({}).are_told());
  EXPECT_FALSE(ArrivalTimes{}.are_told());
}

TEST(ArrivalTimes, AFewFramesOfOneLongMessageMayComeTogether) {
  ArrivalTimes arrivals;
  Record record;
  record.time = 5s;
  for (int i = 0; i < 32; ++i) arrivals.add(record);
  EXPECT_TRUE(arrivals.are_told());
}

}  // namespace
}  // namespace drydock::capture
