#pragma once

#include <span>
#include <vector>

#include "tests/estimators/navigation/recordings/polled_imu.hpp"

namespace drydock::navigation::test {

/// When a polled IMU takes its samples, eq. (R1): a line, and what its oscillator strays from it.
struct OwnClock {
  double first = 0, period = 0;         ///< s
  std::vector<double> stray_at, stray;  ///< s, in order of time

  double stray_near(double t) const;
  double time(long sample) const { return line(sample) + stray_near(line(sample)); }
  /// The newest sample at `t`.
  long newest(double t) const;
  double line(long sample) const { return first + static_cast<double>(sample) * period; }
};

/// Of each poll but the first: does it bring what the poll before brought?
std::vector<bool> repeats_of(std::span<const Poll> polls);

/// The clock that explains the repeats best, slower or faster than the polls. Refused when it
/// leaves more than one repeat in ten unexplained.
Read<OwnClock> own_clock(std::span<const Poll> polls, const std::vector<bool>& repeats);

}  // namespace drydock::navigation::test
