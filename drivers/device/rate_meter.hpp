#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

using measurement::Stamp;

/// Rate of arrivals over the last 64 of them: intervals by the time they took. So jitter and
/// several messages in one read cancel, where a mean or median of 1/interval would not.
class RateMeter {
 public:
  void add(Stamp at) {
    arrivals_[next_] = at;
    next_ = (next_ + 1) % arrivals_.size();
    if (count_ < arrivals_.size()) ++count_;
  }

  void reset() { next_ = count_ = 0; }

  /// Empty until two arrivals at different times.
  std::optional<double> rate_hz() const {
    if (count_ < 2) return {};
    const std::size_t newest = (next_ + arrivals_.size() - 1) % arrivals_.size();
    const std::size_t oldest = (next_ + arrivals_.size() - count_) % arrivals_.size();
    const auto span = arrivals_[newest] - arrivals_[oldest];
    if (span.count() <= 0) return {};
    return static_cast<double>(count_ - 1) / measurement::seconds(span);
  }

 private:
  std::array<Stamp, 64> arrivals_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace drydock::device
