#include "drivers/capture/steady_times.hpp"

#include <gmock/gmock.h>

namespace drydock::capture {
namespace steady_times_test {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

TEST(SteadyTimes, GoOnFromTheLastOneWhereTheClockWasSetBack) {
  SteadyTimes times;
  EXPECT_EQ(times.of("can0", 5000s), 5000s);
  EXPECT_EQ(times.of("can0", 5001s), 5001s);
  EXPECT_EQ(times.of("can0", 1401s), 5001s);
  EXPECT_EQ(times.of("can0", 1402s), 5002s);
  EXPECT_EQ(times.steps(), 1u);
  EXPECT_THAT(times.in_words(), HasSubstr("set back once, by 3600.000 s"));
}

TEST(SteadyTimes, AreThoseOfTheFileWhereTheClockIsSetRightAgain) {
  SteadyTimes times;
  times.of("can0", 5000s);
  EXPECT_EQ(times.of("can0", 1000s), 5000s);
  EXPECT_EQ(times.of("can0", 1001s), 5001s);
  EXPECT_EQ(times.of("can0", 5003s), 5003s);
}

TEST(SteadyTimes, OfTwoInterfacesMayCross) {
  SteadyTimes times;
  times.of("can0", 10s);
  EXPECT_EQ(times.of("can1", 9s), 9s);
  EXPECT_EQ(times.of("can0", 11s), 11s);
  EXPECT_EQ(times.of("can1", 10s), 10s);
  EXPECT_EQ(times.steps(), 0u);
  EXPECT_EQ(times.in_words(), "");
  EXPECT_EQ(times.behind(), 2u);
  EXPECT_EQ(times.most_behind(), 1s);
}

TEST(SteadyTimes, OfAllInterfacesMoveTogether) {
  SteadyTimes times;
  times.of("can0", 100s);
  times.of("can1", 101s);
  EXPECT_EQ(times.of("can0", 42s), 101s);
  EXPECT_EQ(times.of("can1", 43s), 102s);
  EXPECT_EQ(times.of("can0", 44s), 103s);
  EXPECT_EQ(times.steps(), 1u);
}

TEST(SteadyTimes, ASlewIsNoStep) {
  SteadyTimes times;
  times.of("can0", 10s);
  EXPECT_EQ(times.of("can0", 10s - 50ms), 10s - 50ms);
  EXPECT_EQ(times.steps(), 0u);
}

}  // namespace steady_times_test
}  // namespace drydock::capture
