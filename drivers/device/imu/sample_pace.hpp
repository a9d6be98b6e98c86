#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

using measurement::Stamp;

/// The period of a device that counts nothing, and when its present sample could come at the
/// earliest, both from the arrivals of the samples' first frames. Reading only delays a frame. So
/// the earliest arrivals keep the device's pace, and tell how late any other frame is.
class SamplePace {
 public:
  void reset() { *this = {}; }

  /// The first frame of the next sample came. `exactly`: the earliest arrivals go on by the period
  /// as it was known. Else they fall back slowly to those that come, for it is never known exactly.
  void next(Stamp at, bool exactly) {
    if (begun_) steps_[learned_++ % most] = at - last_;
    if (!exactly && learned_ >= fewest && is_time_to_renew()) renew();
    begun_ = true;
    last_ = at;
    constexpr int fall_back = 32;
    const Step step = exactly ? period_ : period_ + period_ / fall_back;
    earliest_ = known() ? std::min(at, earliest_ + step) : at;
  }

  /// The first frame of a sample was lost.
  void miss() { earliest_ += period_; }

  /// Samples before that frame were lost.
  void go_on_from(Stamp at) { earliest_ = at; }

  bool known() const { return period_ > Step::zero(); }
  Stamp::duration period() const { return period_; }

  /// The next sample's frame of the same kind could not have come yet. A sixteenth of a period
  /// is left for the jitter of the bus.
  bool is_in_time(Stamp at) const { return at - earliest_ < period_ - period_ / 16; }

 private:
  using Step = Stamp::duration;
  static constexpr std::size_t most = 255, fewest = 6;
  static constexpr Step shortest = std::chrono::milliseconds{1};  ///< less: read together

  bool is_time_to_renew() const { return learned_ < 32 ? learned_ % 4 == 0 : learned_ % 16 == 0; }

  /// The mean of the steps up to 2.5 times their median. A delay makes one step longer and the next
  /// shorter, so the mean does not feel it. Longer steps are silences, or samples that were lost.
  void renew() {
    std::array<Step, most> used;
    std::size_t n = 0;
    Step all{}, least = Step::max(), largest{};
    for (std::size_t i = 0; i < std::min(learned_, most); ++i) {
      if (steps_[i] < shortest) continue;
      used[n++] = steps_[i];
      all += steps_[i];
      least = std::min(least, steps_[i]);
      largest = std::max(largest, steps_[i]);
    }
    if (n < std::max(fewest / 2, std::min(learned_, most) / 4))
      return;                        // nearly all came in bursts
    if (largest <= least * 5 / 2) {  // then no step is longer than the median allows
      period_ = all / static_cast<int>(n);
      return;
    }
    const auto median = used.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::nth_element(used.begin(), median, used.begin() + static_cast<std::ptrdiff_t>(n));
    const Step longest = *median * 5 / 2;
    Step sum{};
    int count = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (used[i] > longest) continue;
      sum += used[i];
      ++count;
    }
    period_ = sum / count;
  }

  std::array<Step, most> steps_{};
  std::size_t learned_ = 0;
  bool begun_ = false;
  Step period_{};
  Stamp last_{}, earliest_{};
};

}  // namespace drydock::device
