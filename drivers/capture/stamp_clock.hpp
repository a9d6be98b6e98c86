#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "drivers/capture/logger_time.hpp"
#include "drivers/capture/steady_times.hpp"
#include "drivers/wire/day_clock.hpp"

namespace drydock::capture {

/// Times of the lines of a log, from what stands in front of them. Without a date they count from
/// the midnight before the first line, and on over the next.
class StampClock {
 public:
  /// From now on the times are the pauses between lines (`ts -i`), and are summed up.
  void sum_pauses() { pauses_ = true; }

  /// A line's stamp; empty: it has none, or one that is torn.
  void take(const std::optional<LoggerTime>& stamp);
  /// Of the present line, or of one before it: since 1970, or since that midnight.
  std::optional<std::chrono::nanoseconds> last() const { return last_; }

  DateOrder order() const { return order_; }  ///< that dates showed
  bool pauses() const { return pauses_; }
  std::uint64_t timed() const { return timed_; }         ///< stamps with a time
  bool whole_seconds() const { return whole_seconds_; }  ///< no time had a fraction
  /// True if the times are of day: no date stands beside the first one.
  bool without_date() const { return dated_ == false; }
  const SteadyTimes& steady() const { return steady_; }

 private:
  std::optional<std::chrono::nanoseconds> last_;
  std::optional<bool> dated_;  ///< the first time decides it
  DateOrder order_ = DateOrder::unknown;
  wire::DayClock days_;
  SteadyTimes steady_;
  bool whole_seconds_ = true, pauses_ = false;
  std::uint64_t timed_ = 0;
};

}  // namespace drydock::capture
