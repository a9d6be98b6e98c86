#pragma once

#include <algorithm>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::consistency {

using measurement::Stamp;

/// Whether a device repeats exactly the same value, and whether it jumped to that value.
class Freeze {
 public:
  /// `change`: the absolute change from the sample before.
  void see(Stamp at, double change) {
    if (change == 0) {
      if (!since_) since_ = before_;
    } else {
      since_.reset();
      jumped_ = change > unusual * usual_;
      usual_ += (std::min(change, unusual * std::max(usual_, change / unusual)) - usual_) / 16;
    }
    before_ = at;
  }

  /// The time of the first of the equal samples; empty: the last one differed from the one before.
  std::optional<Stamp> since() const { return since_; }
  bool jumped() const { return jumped_; }  ///< the last change was far larger than usual

 private:
  static constexpr double unusual = 10;

  std::optional<Stamp> since_;
  Stamp before_{};
  double usual_ = 0;
  bool jumped_ = false;
};

}  // namespace drydock::consistency
