#include "hil/sky/gps_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace drydock::sky {
namespace {

using namespace std::chrono;
using measurement::Stamp;

constexpr sys_days gps_epoch = 1980y / January / 6;

// IERS Bulletin C: the first UTC day after each leap second.
constexpr std::array<sys_days, 18> leaps{
    1981y / July / 1,    1982y / July / 1,    1983y / July / 1,    1985y / July / 1,
    1988y / January / 1, 1990y / January / 1, 1991y / January / 1, 1992y / July / 1,
    1993y / July / 1,    1994y / July / 1,    1996y / January / 1, 1997y / July / 1,
    1999y / January / 1, 2006y / January / 1, 2009y / January / 1, 2012y / July / 1,
    2015y / July / 1,    2017y / January / 1};

constexpr sys_time<nanoseconds> calendar(Stamp utc) {
  return sys_time<nanoseconds>{utc.time_since_epoch()};
}

}  // namespace

seconds gps_ahead_of_utc(Stamp utc) {
  const auto passed = std::ranges::upper_bound(leaps, calendar(utc));
  return seconds{passed - leaps.begin()};
}

GpsTime gps_time(Stamp utc) { return GpsTime{calendar(utc) - gps_epoch + gps_ahead_of_utc(utc)}; }

Stamp utc_time(GpsTime time) {
  // The first guess ignores leap seconds and is at most 18 s late. It gives the right count except
  // in the seconds after a leap. The second step corrects these.
  const Stamp guess{gps_epoch.time_since_epoch() + time.time_since_epoch()};
  const Stamp near = guess - gps_ahead_of_utc(guess);
  return guess - gps_ahead_of_utc(near);
}

GpsTime gps_time(sys_days date, nanoseconds of_day) { return GpsTime{date - gps_epoch + of_day}; }

GpsWeek week_of(GpsTime time) {
  const auto week = floor<weeks>(time.time_since_epoch());
  return {static_cast<int>(week.count()), time.time_since_epoch() - week};
}

std::string to_string(GpsTime time) {
  const sys_time<nanoseconds> instant = gps_epoch + time.time_since_epoch();
  const auto day = floor<days>(instant);
  const year_month_day date{day};
  const hh_mm_ss clock{floor<seconds>(instant - day)};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02} GPS", int{date.year()},
                     unsigned{date.month()}, unsigned{date.day()}, clock.hours().count(),
                     clock.minutes().count(), clock.seconds().count());
}

}  // namespace drydock::sky
