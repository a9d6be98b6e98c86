#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "drivers/measurement/stamp.hpp"

namespace drydock::sky {

/// GPS system time: continuous since 1980-01-06T00:00:00 UTC, without leap seconds.
struct GpsClock {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = std::chrono::nanoseconds;
  using time_point = std::chrono::time_point<GpsClock, duration>;
  static constexpr bool is_steady = false;
};
using GpsTime = GpsClock::time_point;

/// GPS time minus UTC at a UTC time, s: the IERS leap seconds since 1980. After the last announced
/// leap second (2017-01-01) it stays at 18 s.
std::chrono::seconds gps_ahead_of_utc(measurement::Stamp utc);

GpsTime gps_time(measurement::Stamp utc);
measurement::Stamp utc_time(GpsTime time);

/// A calendar time of GPS time, as RINEX and SP3 write it.
GpsTime gps_time(std::chrono::sys_days date, std::chrono::nanoseconds of_day);

/// Full weeks since 1980 (not modulo 1024) and the time since the week began (Sunday 00:00).
struct GpsWeek {
  int week = 0;
  std::chrono::nanoseconds of_week{};
};
GpsWeek week_of(GpsTime time);

/// `2010-07-01T12:00:00 GPS`, rounded down to seconds.
std::string to_string(GpsTime time);

}  // namespace drydock::sky
