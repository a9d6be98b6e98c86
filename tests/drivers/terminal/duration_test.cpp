#include "drivers/terminal/duration.hpp"

#include <gtest/gtest.h>

using drydock::terminal::parse_duration;

TEST(Duration, ReadsSecondsMinutesAndHours) {
  EXPECT_EQ(parse_duration("90"), 90.0);
  EXPECT_EQ(parse_duration("60s"), 60.0);
  EXPECT_EQ(parse_duration("10min"), 600.0);
  EXPECT_EQ(parse_duration("30d"), 2592000.0);
  EXPECT_EQ(parse_duration("5.5h"), 19800.0);
}

TEST(Duration, RefusesWhatIsNone) {
  for (const char* text : {"", "s", "-5s", "5 s", "1w", "nan", "inf", "5parsec", "0x10"}) {
    EXPECT_EQ(parse_duration(text), std::nullopt) << text;
  }
}

TEST(Duration, EndsWhereAStampWould) {
  EXPECT_EQ(parse_duration("876600h"), 3155760000.0);
  for (const char* text : {"876601h", "1e18s", "1e300h"}) {
    EXPECT_EQ(parse_duration(text), std::nullopt) << text;
  }
}
