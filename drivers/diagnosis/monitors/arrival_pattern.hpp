#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "drivers/diagnosis/monitors/raster.hpp"
#include "drivers/diagnosis/monitors/thinned_rate.hpp"

namespace drydock::diagnosis {

/// The last steps of one stream of messages, and the shapes that can be seen in them.
class ArrivalPattern {
 public:
  void add(const Raster::Arrival& arrival, double period_s) {
    crowded_ = crowded_ << 1 | (arrival.step == Step::crowded ? 1U : 0U);
    note_thinned(arrival);
    if (arrival.step == Step::crowded) return;
    intervals_[next_++ % intervals_.size()] = arrival.interval_s;
    const bool pause = arrival.interval_s > long_interval * period_s;
    pauses_in_a_row_ = pause ? pauses_in_a_row_ + 1 : 0;
    const bool other = std::abs(arrival.interval_s / period_s - 1) > least_change &&
                       next_ >= intervals_.size() && alike(intervals_, 0.12);
    other_s_ = other ? other_s_ + arrival.interval_s : 0;
    if (pause) pauses_[next_pause_++ % pauses_.size()] = arrival.interval_s;
  }
  void clear() { *this = {}; }

  /// Pauses of one length, each followed by what was held and then by the next pause.
  bool bunched() const {
    constexpr int fewest = 5, fewest_of_8 = 3;
    constexpr double shortest_s = 1.2;  // of all those pauses
    if (held_by_less_than_two()) return true;
    return std::popcount(crowded_ & 0xFFU) >= fewest_of_8 && pauses_in_a_row_ >= fewest &&
           alike(pauses_, 0.03) && fewest * pauses_[0] > shortest_s;
  }
  /// All intervals of the last time are longer (or shorter) than the period by one factor, each of
  /// them or in turn. 1: they are not.
  double slower(double period_s) const {
    if (held_by_less_than_two()) return 1;
    return other_s_ > alike_for_s ? intervals_[0] / period_s : thinned_;
  }
  /// Length of the last pauses together.
  double pauses_s() const {
    const double pause_s = held_by_less_than_two() ? intervals_[0] : pauses_[0];
    return static_cast<double>(pauses_.size()) * pause_s;
  }

 private:
  static constexpr double long_interval = 1.6;  ///< periods
  static constexpr double least_change = 0.2;   ///< of a rate
  static constexpr double alike_for_s = 0.5;

  /// Pauses between one and two periods: not each has a second message behind it. A slow sensor
  /// sends no message right behind another.
  bool held_by_less_than_two() const {
    return other_s_ > alike_for_s && std::popcount(crowded_ & 0xFFFFU) >= 2 &&
           alike(intervals_, 0.03);
  }
  template <std::size_t N>
  static bool alike(const std::array<double, N>& intervals, double spread) {
    const auto [least, most] = std::ranges::minmax(intervals);
    return most - least < spread * most;
  }

  /// Only what is missing tells of it.
  void note_thinned(const Raster::Arrival& arrival) {
    thinned_ = 1;
    if (arrival.step == Step::crowded || arrival.step == Step::odd) return thinned_rate_.clear();
    thinned_rate_.add(arrival.slots);
    if (arrival.step != Step::missing) return;
    const double times = thinned_rate_.times();
    if (times > 1 + least_change) thinned_ = times;
  }

  std::uint32_t crowded_ = 0;  ///< one bit a message, the latest lowest
  std::array<double, 6> intervals_{};
  std::array<double, 4> pauses_{};
  std::size_t next_ = 0, next_pause_ = 0;
  ThinnedRate thinned_rate_;
  double thinned_ = 1;       ///< as of the latest message
  double other_s_ = 0;       ///< how long all intervals have been alike and not the period
  int pauses_in_a_row_ = 0;  ///< with nothing on the raster between them
};

}  // namespace drydock::diagnosis
