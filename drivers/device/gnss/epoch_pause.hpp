#pragma once

#include <algorithm>
#include <chrono>

namespace drydock::device {

/// How long a line is silent when the epoch of its receiver is over. A baud rate tells it. Without
/// one (a network, a logger's lines) sentences of one epoch may stand apart, so the first epochs
/// get the longest time, and the pauses inside them tell it for those behind.
class EpochPause {
 public:
  static constexpr std::chrono::milliseconds longest{500};

  EpochPause(std::chrono::nanoseconds shortest, bool known)
      : shortest_(shortest), to_learn_from_(known ? 0 : epochs_to_learn) {}

  std::chrono::nanoseconds length() const {
    if (to_learn_from_ > 0) return longest;
    return std::clamp<std::chrono::nanoseconds>(inside_ * 3 / 2, shortest_, longest);
  }
  /// Two messages of one epoch stood so far apart, also where the second one came too late for it.
  void was_inside(std::chrono::nanoseconds pause) { inside_ = std::max(inside_, pause); }
  /// One delay of a host is forgotten after some epochs.
  void epoch_is_over() {
    if (to_learn_from_ > 0) --to_learn_from_;
    inside_ -= inside_ / 32;
  }

 private:
  static constexpr int epochs_to_learn = 3;
  std::chrono::nanoseconds shortest_, inside_{};
  int to_learn_from_;
};

}  // namespace drydock::device
