#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

using measurement::Stamp;

/// Regularity of arrivals.
struct Jitter {
  double deviation_s = 0;         ///< standard deviation of the intervals
  double longest_interval_s = 0;  ///< the longest gap
};

/// Rate of the last 64 arrivals: the number of intervals divided by their total time. Thus jitter
/// and several messages in one read cancel; in a mean or median of 1/interval they would not.
class RateMeter {
 public:
  void add(Stamp at) {
    arrivals_[next_] = at;
    next_ = (next_ + 1) % arrivals_.size();
    if (count_ < arrivals_.size()) ++count_;
  }

  void reset() { next_ = count_ = 0; }

  /// Empty until there are two arrivals at different times.
  std::optional<double> rate_hz() const {
    if (count_ < 2) return {};
    const auto span = arrival(count_ - 1) - arrival(0);
    if (span.count() <= 0) return {};
    return static_cast<double>(count_ - 1) / measurement::seconds(span);
  }

  /// Of the same intervals. Empty until there are two intervals.
  std::optional<Jitter> jitter() const {
    if (count_ < 3) return {};
    const auto intervals = static_cast<double>(count_ - 1);
    const double mean = measurement::seconds(arrival(count_ - 1) - arrival(0)) / intervals;
    double squares = 0, longest = 0;
    for (std::size_t i = 1; i < count_; ++i) {
      const double interval = measurement::seconds(arrival(i) - arrival(i - 1));
      squares += (interval - mean) * (interval - mean);
      longest = std::max(longest, interval);
    }
    return Jitter{std::sqrt(squares / intervals), longest};
  }

 private:
  /// Counts from the oldest arrival that is kept.
  Stamp arrival(std::size_t i) const {
    return arrivals_[(next_ + arrivals_.size() - count_ + i) % arrivals_.size()];
  }

  std::array<Stamp, 64> arrivals_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace drydock::device
