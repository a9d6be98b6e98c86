#include "drivers/wire/described/notation.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/drivers/described/driven.hpp"

/// Times of day and dates, as sensors write them.
namespace drydock::described::test {
namespace notation_test {

using measurement::GnssFix;
using ::testing::HasSubstr;
using wire::described::notation_named;
using wire::described::value_in;

std::optional<double> value(std::string_view unit, std::string_view text) {
  return value_in(notation_named(unit).value(), text);
}

std::string written(std::string_view unit, double value, unsigned decimals = 0) {
  std::array<char, 32> out{};
  const auto size = wire::described::write_in(notation_named(unit).value(), value, decimals,
                                              out.data(), out.data() + out.size());
  return {out.data(), size};
}

TEST(TimesOfDay, AreSecondsSinceMidnight) {
  EXPECT_EQ(value("hhmmss", "123519"), 12 * 3600 + 35 * 60 + 19);
  EXPECT_EQ(value("hhmmss", "235959.75"), 86399.75);
  EXPECT_EQ(value("hhmmss", "93519.5"), 9 * 3600 + 35 * 60 + 19.5) << "no zero in front";
  EXPECT_EQ(value("hh:mm:ss", "00:00:01.25"), 1.25);
  EXPECT_EQ(value("hh:mm:ss", "7:05:09"), 7 * 3600 + 5 * 60 + 9);
  EXPECT_EQ(value("hhmmss", "235960"), 86400) << "a leap second";
}

TEST(TimesOfDay, ThatDoNotExistAreNoValue) {
  for (const char* text :
       {"240000", "126000", "120061", "12:35:19", "1235", "", "12351a", "-23519"})
    EXPECT_FALSE(value("hhmmss", text)) << text;
  for (const char* text : {"123519", "12:35", "12:61:00", "12::00"})
    EXPECT_FALSE(value("hh:mm:ss", text)) << text;
}

// date -u -d 2026-11-26 +%s and its like.
TEST(Dates, AreSecondsSince1970) {
  EXPECT_EQ(value("ddmmyy", "261126"), 1795651200);
  EXPECT_EQ(value("mmddyy", "112626"), 1795651200);
  EXPECT_EQ(value("yyyy-mm-dd", "2026-11-26"), 1795651200);
  EXPECT_EQ(value("dd/mm/yyyy", "26/11/2026"), 1795651200);
  EXPECT_EQ(value("dd.mm.yyyy", "1.2.2024"), 1706745600);
  EXPECT_EQ(value("yymmdd", "991231"), 946598400) << "1999";
  EXPECT_EQ(value("yyyymmdd", "20240229"), 1709164800) << "a leap day";
}

TEST(Dates, ThatDoNotExistAreNoValue) {
  EXPECT_FALSE(value("ddmmyy", "310226"));
  EXPECT_FALSE(value("yyyymmdd", "20230229"));
  EXPECT_FALSE(value("yyyy-mm-dd", "2026-13-01"));
  EXPECT_FALSE(value("mm/dd/yy", "26/11/26"));
}

TEST(TimesOfDay, AreWrittenAsTheyAreRead) {
  EXPECT_EQ(written("hhmmss", 9 * 3600 + 5 * 60 + 3.25, 2), "090503.25");
  EXPECT_EQ(written("hh:mm:ss", 86399.9996, 3), "00:00:00.000") << "never 60 seconds";
  EXPECT_EQ(written("hhmmss", 1795651200 + 3661.0), "010101") << "of the day";
  EXPECT_EQ(written("ddmmyy", 1795651200 + 3661.0), "261126");
  EXPECT_EQ(written("yyyy/mm/dd", 1709164800), "2024/02/29");
}

constexpr const char* gnss = R"(
[sensor]
title = "position with its time"
kind = "gnss"
[protocol]
[[protocol.sentences]]
id = "$PXPOS"
fields = [
  {{ field = "utc_s", unit = "hhmmss", decimals = 2 }},
  {{ {} }},
  {{ field = "latitude_deg", unit = "deg", decimals = 7 }},
  {{ field = "longitude_deg", unit = "deg", decimals = 7 }},
]
)";

TEST(TimesOfDay, AndTheDateOfTheMessageAreItsUtc) {
  const auto description = described(fmt::format(gnss, R"(field = "date_s", unit = "ddmmyy")"));
  Heard heard;
  receive(*driver_of(description), "$PXPOS,123519.25,261126,54.5,10.25*52\r\n", {}, heard);
  ASSERT_EQ(heard.all.size(), 1u);
  ASSERT_TRUE(heard.last<GnssFix>().utc);
  EXPECT_EQ(heard.last<GnssFix>().utc->time_since_epoch(),
            std::chrono::milliseconds{1795651200'000 + 45319'250});
}

TEST(TimesOfDay, WithoutADateAreNoUtc) {
  EXPECT_THAT(
      problems_of(fmt::format(gnss, "skip = true")),
      HasSubstr("toy.toml:6:1: /protocol/sentences/0: a UTC has a time and a date; this one "
                "lacks date_s"));
}

TEST(TimesOfDay, OfAnEmulatedReceiverAreThoseOfTheTruth) {
  Bench bench(described(fmt::format(gnss, R"(field = "date_s", unit = "yyyy-mm-dd")")), 5,
              emulate::at_the_surface());
  bench.run(2);
  ASSERT_GE(bench.all.size(), 9u);
  const auto& fix = std::get<GnssFix>(bench.all.back());
  EXPECT_LT(std::abs((*fix.utc - fix.origin.valid_at).count()), 5'000'000) << "ns";
}

/// The clock of the device goes on over midnight where no message has the date.
TEST(TimesOfDay, OfADeviceWithoutADateGoOnOverMidnight) {
  const auto description = described(R"(
[sensor]
title = "depth with a time of day"
kind = "depth"
[protocol]
[[protocol.lines]]
name = "depth"
head = "D "
fields = [{ field = "time_s", unit = "hh:mm:ss", ends = " " }, { field = "depth_m", unit = "m" }]
)");
  Heard heard;
  receive(*driver_of(description), "D 23:59:59.5 12.5\r\nD 00:00:00.5 12.6\r\n", {}, heard);
  ASSERT_EQ(heard.all.size(), 2u);
  const auto time_of = [&](std::size_t i) {
    return std::get<measurement::DepthSample>(heard.all[i]).origin.device_time.value();
  };
  EXPECT_EQ(time_of(0), std::chrono::milliseconds{86399'500});
  EXPECT_EQ(time_of(1) - time_of(0), std::chrono::seconds{1});
}

}  // namespace notation_test
}  // namespace drydock::described::test
