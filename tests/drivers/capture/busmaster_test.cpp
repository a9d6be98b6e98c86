#include <gmock/gmock.h>

#include "tests/drivers/capture/captures.hpp"

/// The times and bases of BUSMASTER's logs.
namespace drydock::capture::testing {
namespace busmaster_test {

using ::testing::ElementsAre;
using namespace std::chrono_literals;

std::vector<std::chrono::nanoseconds> times_of(const std::string& mode, const std::string& lines) {
  const Outcome outcome = read_capture("***BUSMASTER Ver 2.4.0***\n***START DATE AND TIME " +
                                       std::string("23:9:2015 22:17:28:928***\n***HEX***\n***") +
                                       mode + " MODE***\n" + lines);
  EXPECT_EQ(outcome.damaged, 0u);
  std::vector<std::chrono::nanoseconds> times;
  for (const Seen& seen : outcome.records) times.push_back(seen.time.value());
  return times;
}

// date -u -d "2015-09-23 22:17:28.928" +%s.%N
constexpr auto start = 1443046648928ms;

TEST(BusmasterFile, MillisecondsHaveUpToThreeDigitsAndTenthsOfThemFour) {
  EXPECT_THAT(times_of("SYSTEM",
                       "22:20:15:2 Rx 0 000002A2 s 1 00 \n22:20:15:12 Rx 0 000002A2 s 1 00 \n"
                       "22:20:15:0131 Rx 1 0x2A2 s 1 00\n"),
              ElementsAre(1443046815002ms, 1443046815012ms, 1443046815013ms + 100us));
}

TEST(BusmasterFile, TimesOfDayGoOnOverMidnight) {
  EXPECT_THAT(times_of("SYSTEM", "23:59:59:9990 Rx 1 0x2A2 s 0\n00:00:00:0010 Rx 1 0x2A2 s 0\n"),
              ElementsAre(1443052799999ms, 1443052800001ms));
}

TEST(BusmasterFile, TimesMayCountFromTheStartOrFromTheFrameBefore) {
  const std::string lines = "00:00:01:0000 Rx 1 0x2A2 s 0\n00:00:02:0000 Rx 1 0x2A2 s 0\n";
  EXPECT_THAT(times_of("ABSOLUTE", lines), ElementsAre(start + 1s, start + 2s));
  EXPECT_THAT(times_of("RELATIVE", lines), ElementsAre(start + 1s, start + 3s));
}

TEST(BusmasterFile, NumbersMayBeDecimal) {
  const Seen seen =
      only("***BUSMASTER Ver 1.6.2***\n***DEC***\n00:00:01:0000 Tx 2 291 s 2 17 255\n");
  EXPECT_EQ(seen.frame.id, 0x123u);
  EXPECT_EQ(seen.interface, "can1");
  EXPECT_THAT(data_of(seen), ElementsAre(0x11, 0xFF));
}

TEST(BusmasterFile, WhatIsNoFrameOfCanIsCounted) {
  const Outcome outcome = read_capture(
      "***BUSMASTER Ver 2.4.0***\n11:49:12:9420 Rx 1 0x023 s 1 40\n11:49:12:9420 Rx 1 0x823 s 1 "
      "40\n"
      "11:49:12:9420 Rx 1 0x023 s 2 40\n11:49:12:9420 Rx 1 0x023 e 1 40\n"
      "11:49:12:9420 Rx 1 0x023 s 9 40\n11:61:12:9420 Rx 1 0x023 s 1 40\n");
  EXPECT_EQ(outcome.records.size(), 1u);
  EXPECT_EQ(outcome.damaged, 5u);
}

}  // namespace busmaster_test
}  // namespace drydock::capture::testing
