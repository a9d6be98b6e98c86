#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "drivers/diagnosis/raster.hpp"

namespace drydock::diagnosis {

/// The last steps of one stream of messages, and the shapes that can be seen in them.
class ArrivalPattern {
 public:
  void add(const Raster::Arrival& arrival, double period_s) {
    crowded_ = crowded_ << 1 | (arrival.step == Step::crowded ? 1U : 0U);
    odd_ = odd_ << 1 | (arrival.step == Step::odd ? 1U : 0U);
    if (arrival.step == Step::crowded) return;
    intervals_[next_++ % intervals_.size()] = arrival.interval_s;
    if (arrival.interval_s > long_interval * period_s)
      pauses_[next_pause_++ % pauses_.size()] = arrival.interval_s;
  }
  void clear() { *this = {}; }

  /// Pauses of one length, and behind each of them what was held.
  bool bunched() const {
    constexpr int fewest_of_16 = 5;
    return next_pause_ >= pauses_.size() && std::popcount(crowded_ & 0xFFFFU) >= fewest_of_16 &&
           alike(pauses_);
  }
  /// All intervals are longer (or shorter) than the period by one factor. 1: they are not.
  double slower(double period_s) const {
    constexpr double least = 0.2;
    if (next_ < intervals_.size() || !alike(intervals_)) return 1;
    const double factor = intervals_[0] / period_s;
    return std::abs(factor - 1) > least ? factor : 1;
  }
  int odd_of_32() const { return std::popcount(odd_); }

 private:
  static constexpr double long_interval = 1.6;  ///< periods
  template <std::size_t N>
  static bool alike(const std::array<double, N>& intervals) {
    const auto [least, most] = std::ranges::minmax(intervals);
    constexpr double spread = 0.12;
    return most - least < spread * most;
  }

  std::uint32_t crowded_ = 0, odd_ = 0;  ///< one bit a message, the latest lowest
  std::array<double, 6> intervals_{};
  std::array<double, 3> pauses_{};
  std::size_t next_ = 0, next_pause_ = 0;
};

}  // namespace drydock::diagnosis
