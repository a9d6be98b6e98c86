#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "estimators/pipeline/gate_limits.hpp"

namespace drydock::pipeline {

/// Finds where the rate of one gyro leaps from one sample to the next by more than its noise, and
/// stays there: (I11) of docs/estimators/integrity.md. A body that spins up changes its rate
/// evenly, which counts for nothing. Allocates nothing.
class RateLeap {
 public:
  /// Of a standard normal value, two-sided 2e-9.
  static constexpr double limit = 6;
  /// A leap bends neither side by more than a third of itself.
  static constexpr double times_bent = 3;

  /// `noise`: one sigma of a sample. Returns the leap between the 16th and the 17th newest
  /// sample; 0: there is none. rad/s.
  double add(double rate, double noise) {
    std::shift_left(rates_.begin(), rates_.end(), 1);
    rates_.back() = rate;
    if (++known_ < rates_.size()) return 0;
    const double leap = 1.5 * (mean(2) - mean(1)) - 0.5 * (mean(3) - mean(0));
    constexpr double sigmas = 0.791;  // the root of 2 (1.5^2 + .5^2) / 8
    // A leap elsewhere than in the middle bends one side.
    const double bent = times_bent * std::abs((mean(3) - mean(2)) - (mean(1) - mean(0)));
    const double least = std::max({limit * sigmas * noise, gate::least_turn, bent});
    if (!(std::abs(leap) > least)) return 0;
    known_ = 0;
    return leap;
  }
  void forget() { known_ = 0; }

 private:
  /// Of the samples of one quarter.
  double mean(int quarter) const {
    const auto begin = rates_.begin() + 8 * quarter;
    return std::accumulate(begin, begin + 8, 0.0) / 8;
  }

  std::array<double, 32> rates_{};  ///< the newest last
  std::size_t known_ = 0;           ///< samples since the last leap or gap
};

}  // namespace drydock::pipeline
