#pragma once

#include <algorithm>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::consistency {

using measurement::Stamp;

/// What the history of a device alone says: whether it repeats exactly the same value, and when it
/// last changed far more than usual.
class Freeze {
 public:
  /// `change`: the absolute change from the sample before; of the first one it means nothing.
  void see(Stamp at, double change) {
    if (before_ == Stamp{}) {
      before_ = at;
      return;
    }
    if (change == 0) {
      if (++equal_ == 1) since_ = before_;
    } else {
      equal_ = 0;
      note_jump(at, change);
      usual_ += (std::min(change, unusual * std::max(usual_, change / unusual)) - usual_) / 16;
    }
    before_ = at;
  }

  /// The time of the first of at least five equal samples; empty: they differ.
  std::optional<Stamp> since() const {
    return equal_ < enough_equal ? std::nullopt : std::optional(since_);
  }
  bool jumped() const { return jumped_; }  ///< the last change was far larger than usual

  /// The largest change near a time, in usual changes; 0: none is known there.
  double surprise(Stamp near) const {
    return std::chrono::abs(jump_at_ - near) < std::chrono::seconds{2} ? jump_ : 0;
  }

 private:
  static constexpr double unusual = 10;
  static constexpr int enough_equal = 4;

  void note_jump(Stamp at, double change) {
    const double times = change / std::max(usual_, change / 1000);
    jumped_ = times > unusual;
    if (times < jump_ && at - jump_at_ < std::chrono::seconds{3}) return;
    jump_ = times;
    jump_at_ = at;
  }

  Stamp since_{};
  int equal_ = 0;
  Stamp before_{}, jump_at_{};
  double usual_ = 0, jump_ = 0;
  bool jumped_ = false;
};

}  // namespace drydock::consistency
