#pragma once

#include <algorithm>

#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

/// A bus that carries nothing for half a second, and for twenty usual pauses, was not heard.
class BusSilence {
 public:
  /// `pause_s`: from the latest frame to this one.
  bool is_deaf(double pause_s) {
    const bool deaf = pause_s > std::max(shortest_s, pauses * usual_pause_s_);
    usual_pause_s_ += (std::min(pause_s, shortest_s) - usual_pause_s_) / memory;
    return deaf;
  }

 private:
  static constexpr double shortest_s = 0.5, pauses = 20;
  static constexpr double memory = 64;  // frames
  double usual_pause_s_ = 0;
};

}  // namespace drydock::diagnosis
