#pragma once

#include <span>
#include <vector>

#include "tests/estimators/navigation/recordings/polled_imu.hpp"

namespace drydock::navigation::test {

/// The times at which a polled IMU takes its samples, eq. (R1): a line, plus the stray of its
/// oscillator from this line.
struct OwnClock {
  double first = 0, period = 0;         ///< s
  std::vector<double> stray_at, stray;  ///< s, in order of time

  double stray_near(double t) const;
  double time(long sample) const { return line(sample) + stray_near(line(sample)); }
  /// The number of the newest sample at `t`.
  long newest(double t) const;
  double line(long sample) const { return first + static_cast<double>(sample) * period; }
};

/// For each poll but the first: true if it has the same value as the poll before.
std::vector<bool> repeats_of(std::span<const Poll> polls);

/// The clock that explains the repeats best. It may be slower or faster than the polls. Refused if
/// it leaves more than one repeat in ten unexplained.
Read<OwnClock> own_clock(std::span<const Poll> polls, const std::vector<bool>& repeats);

}  // namespace drydock::navigation::test
