#pragma once

#include <cstdint>

namespace drydock::device {

/// Tells by the ticks of a device whether a group of messages follows the one before it, or others
/// between them were lost. The shortest step that was seen is the device's period.
class GroupOrder {
 public:
  void reset() { *this = {}; }

  /// True if no group lies between that of these ticks and the one before. The counter may wrap.
  bool follows(std::uint32_t ticks) {
    const std::uint32_t step = ticks - last_;
    const bool first = !begun_;
    begun_ = true;
    last_ = ticks;
    if (first || step == 0) return false;
    if (period_ == 0 || step < period_) period_ = step;
    return steps_++ > 0 && step - period_ <= period_ / most_jitter;
  }

 private:
  static constexpr std::uint32_t most_jitter = 4;  ///< a quarter of a period

  std::uint32_t last_ = 0, period_ = 0, steps_ = 0;
  bool begun_ = false;
};

}  // namespace drydock::device
