#pragma once

#include <algorithm>
#include <chrono>

#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// By how much the computer itself may have made a message late, s.
struct HostLate {
  double now_s = 0;     ///< it came when this program had just woken late
  double lately_s = 0;  ///< the most by which this program woke late in the last seconds
};

/// When this program woke too late to take what its links brought. What waited comes right behind,
/// some of it later still: a worker of the kernel hands on the bytes of a serial port, and waits
/// for a processor like this program.
class HostLateness {
 public:
  /// This program asks so often to be woken: it may have been held so long before it was due.
  static constexpr std::chrono::milliseconds asked_each{2};

  void add(Stamp due, Stamp woke) {
    const bool goes_on = due < woke_ + behind() && woke - due_ < longest_spell;
    if (!goes_on) due_ = due;
    woke_ = woke;
    late_ = woke - due;
    if (late_ < most_ && woke < most_until_) return;
    most_ = late_;
    most_until_ = woke + lately;
  }

  HostLate at(Stamp arrival) const {
    HostLate late;
    if (arrival >= due_ && arrival < woke_ + behind())
      late.now_s = measurement::seconds(std::max(arrival, woke_) - due_ + asked_each);
    if (arrival < most_until_) late.lately_s = measurement::seconds(most_);
    return late;
  }

 private:
  static constexpr std::chrono::nanoseconds longest_behind = std::chrono::milliseconds{5},
                                            longest_spell = std::chrono::milliseconds{100};
  static constexpr std::chrono::seconds lately{5};

  std::chrono::nanoseconds behind() const { return std::min(longest_behind, late_); }

  Stamp due_{}, woke_{};  ///< the last spell of late wakes, one right behind the other
  std::chrono::nanoseconds late_{0}, most_{0};  ///< of the last wake, of the last seconds
  Stamp most_until_{};
};

}  // namespace drydock::diagnosis
