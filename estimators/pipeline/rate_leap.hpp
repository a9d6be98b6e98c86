#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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
    const auto ago = [this](std::size_t samples) { return rates_[(next_ - samples) % size]; };
    sums_[3] += rate - ago(8);
    sums_[2] += ago(8) - ago(16);
    sums_[1] += ago(16) - ago(24);
    sums_[0] += ago(24) - ago(size);
    rates_[next_++ % size] = rate;
    if (++known_ < size) return 0;
    const double first = (sums_[1] - sums_[0]) / 8, last = (sums_[3] - sums_[2]) / 8;
    const double leap = (sums_[2] - sums_[1]) / 8 - 0.5 * (first + last);
    constexpr double sigmas = 0.791;  // the root of 2 (1.5^2 + .5^2) / 8
    // A leap elsewhere than in the middle bends one side.
    const double bent = times_bent * std::abs(last - first);
    const double least = std::max({limit * sigmas * noise, gate::least_turn, bent});
    if (!(std::abs(leap) > least)) return 0;
    known_ = 0;
    return leap;
  }
  void forget() { known_ = 0; }

 private:
  static constexpr std::size_t size = 32;

  std::array<double, size> rates_{};  ///< a ring
  std::array<double, 4> sums_{};      ///< of the four quarters, the newest last
  std::size_t next_ = size;           ///< place in the ring, modulo its size
  std::size_t known_ = 0;             ///< samples since the last leap or gap
};

}  // namespace drydock::pipeline
