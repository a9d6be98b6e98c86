#include "drivers/capture/logger_time.hpp"

#include <gtest/gtest.h>

/// Times that loggers write in front of sentences.
namespace drydock::capture::testing {
namespace logger_time_test {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr milliseconds date_says{1704067170'100};  // date -u -d 2023-12-31T23:59:30.1Z +%s.%N

TEST(LoggerTime, IsReadAsKnownLoggersWriteIt) {
  for (const char* text : {"2023-12-31T23:59:30.100Z ", "[2023-12-31 23:59:30,1] ",
                           "2023/12/31 23:59:30.100000 COM3: ", "2024-01-01T00:59:30.100+01:00\t",
                           "2023-12-31T20:29:30.1-0330 ", "1704067170.100000 ", "1704067170100;N;",
                           "(1704067170100000) ", "1704067170100000000,",
                           "\"AP\",\"RX\",\"2023-12-31T23:59:30.100Z\",\"NMEA0183\",\""}) {
    const auto found = logger_time(text);
    ASSERT_TRUE(found) << text;
    EXPECT_EQ(found->time, date_says) << text;
    EXPECT_FALSE(found->of_day || found->whole_second) << text;
  }
}

TEST(LoggerTime, WithoutADateIsATimeOfDay) {
  const auto found = logger_time("COM12 (9600 baud) 23:59:30.250 RX: ");
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->of_day);
  EXPECT_EQ(found->time, milliseconds{86370'250});
}

TEST(LoggerTime, OfWholeSecondsSaysSo) {
  EXPECT_TRUE(logger_time("2023-12-31 23:59:30 ")->whole_second);
  EXPECT_TRUE(logger_time("1704067170 ")->whole_second);
  EXPECT_FALSE(logger_time("1704067170000 ")->whole_second);
}

TEST(LoggerTime, IsNoOtherNumber) {
  for (const char* text : {"", "COM3 ", "192.168.1.100:10110 ", "12345 ", "25:00:00 ",
                           "2023-13-31T23:59 ", "00000000001 ", "0123456789 "})
    EXPECT_FALSE(logger_time(text)) << text;
}

TEST(LoggerTime, OfATagBlockIsItsC) {
  EXPECT_EQ(tag_block_time("\\s:GP0001,c:1704067170*47\\")->time, std::chrono::seconds{1704067170});
  EXPECT_EQ(tag_block_time("\\c:1704067170100,s:x*00\\")->time, date_says);
  EXPECT_FALSE(tag_block_time("\\g:2-2-73*11\\"));
}

}  // namespace logger_time_test
}  // namespace drydock::capture::testing
