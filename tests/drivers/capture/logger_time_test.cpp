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

/// The loggers of research vessels, terminals and spreadsheets; date -u -d 2019-03-26T10:05:55.299Z
/// +%s%3N, and date +%j for the day of the year.
TEST(LoggerTime, IsReadWithTheDateOfEachKnownLogger) {
  constexpr milliseconds as_date_says{1553594755'299};
  for (const char* text : {"19+085:10:05:55.299 ",
                           "2019:085:10:05:55.299,",
                           "2019-085T10:05:55.299Z ",
                           "20190326T100555.299Z ",
                           "20190326-100555.299 ",
                           "20190326100555.299,",
                           "20190326 10:05:55.299 ",
                           "26.03.2019 10:05:55.299 ",
                           "26.3.2019 10:05:55,299 ",
                           "03/26/2019,10:05:55.299,",
                           "3/26/2019 10:05:55.299 AM ",
                           "26/03/2019 10:05:55.299 ",
                           "[Tue Mar 26 10:05:55.299 2019] ",
                           "26 Mar 2019 10:05:55.299 ",
                           "26-MAR-2019 10:05:55.299,",
                           "Mar 26, 2019 10:05:55.299 ",
                           "2019 Mar 26 10:05:55.299 ",
                           "2019:03:26:10:05:55.299 ",
                           "2019.03.26_10:05:55.299 ",
                           "2019-03-26 12:05:55.299 +0200 ",
                           "20190326T080555.299-0200 ",
                           "gyr1 2019-03-26T10:05:55.299000Z "}) {
    const auto found = logger_time(text);
    ASSERT_TRUE(found) << text;
    EXPECT_FALSE(found->of_day) << text;
    EXPECT_EQ(found->time, as_date_says) << text;
  }
}

TEST(LoggerTime, OfADateThatMayBeReadInTwoWaysIsATimeOfDayUntilItsOrderIsKnown) {
  constexpr milliseconds december{1418169600'000}, october{1412985600'000};  // 10th, 11th: 00:00 h
  EXPECT_TRUE(logger_time("10/12/2014,00:00:00.0,")->of_day);
  EXPECT_EQ(logger_time("10/12/2014,00:00:00.0,", DateOrder::day_first)->time, december);
  EXPECT_EQ(logger_time("10/11/2014,00:00:00.0,", DateOrder::month_first)->time, october);
  EXPECT_EQ(logger_time("10/13/2014,00:00:00.0,")->order, DateOrder::month_first);
  EXPECT_EQ(logger_time("13/10/2014,00:00:00.0,")->order, DateOrder::day_first);
  EXPECT_EQ(logger_time("10.12.2014 00:00:00.0 ")->time, december);
}

TEST(LoggerTime, OfTwelveHoursIsOfTwentyFour) {
  const auto of = [](const char* text) { return logger_time(text)->time; };
  EXPECT_EQ(of("1:02:03.5 PM "), milliseconds{46923'500});
  EXPECT_EQ(of("12:02:03 AM "), milliseconds{123'000});
  EXPECT_EQ(of("12:02:03 pm "), milliseconds{43323'000});
}

TEST(LoggerTime, WithoutADateIsATimeOfDay) {
  const auto found = logger_time("COM12 (9600 baud) 23:59:30.250 RX: ");
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->of_day);
  EXPECT_EQ(found->time, milliseconds{86370'250});
  // Of syslog the year is missing.
  EXPECT_TRUE(logger_time("Mar 26 10:05:00 host nmea: ")->of_day);
  EXPECT_TRUE(logger_time("10.20.30.100 10:05:00 ")->of_day) << "an address is no date";
}

TEST(LoggerTime, OfWholeSecondsSaysSo) {
  EXPECT_TRUE(logger_time("2023-12-31 23:59:30 ")->whole_second);
  EXPECT_TRUE(logger_time("1704067170 ")->whole_second);
  EXPECT_FALSE(logger_time("1704067170000 ")->whole_second);
}

TEST(LoggerTime, IsNoOtherNumber) {
  for (const char* text :
       {"", "COM3 ", "192.168.1.100:10110 ", "12345 ", "25:00:00 ", "2023-13-31T23:59 ",
        "00000000001 ", "0123456789 ", "00:11:22:33:44:55 "})
    EXPECT_FALSE(logger_time(text)) << text;
}

TEST(LoggerTime, OfATagBlockIsItsC) {
  EXPECT_EQ(tag_block_time("\\s:GP0001,c:1704067170*47\\")->time, std::chrono::seconds{1704067170});
  EXPECT_EQ(tag_block_time("\\c:1704067170100,s:x*00\\")->time, date_says);
  EXPECT_FALSE(tag_block_time("\\g:2-2-73*11\\"));
}

}  // namespace logger_time_test
}  // namespace drydock::capture::testing
