#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace drydock::pipeline {

/// The noise of a sensor from the differences of successive innovations: half of their square is
/// the variance of white noise in the mean (von Neumann 1941), whatever slow error is below it. A
/// long mean is kept, and the median of the last few, so that a sensor that becomes noisy counts as
/// such at once, and one that jumps does not.
class SuccessiveNoise {
 public:
  /// `at_first`: the variance until differences have come; `least`: it is never less.
  explicit SuccessiveNoise(double at_first, double least) : mean_(at_first), least_(least) {
    last_few_.fill(median_of_square * at_first);
  }

  void add(double innovation) {
    if (count_ > 0) {
      const double half_square = 0.5 * (innovation - last_) * (innovation - last_);
      last_few_[count_ % few] = half_square;
      const double usual = std::min(half_square, largest * variance());
      mean_ += (usual - mean_) / static_cast<double>(std::min(samples, count_ + 1));
    }
    last_ = innovation;
    ++count_;
  }

  double variance() const {
    auto sorted = last_few_;
    std::ranges::nth_element(sorted, sorted.begin() + few / 2);
    const double now = sorted[few / 2] / median_of_square;
    return std::max(least_, now > noisier * mean_ ? now : mean_);
  }

 private:
  static constexpr std::size_t samples = 100, few = 7;
  static constexpr double median_of_square = 0.455;  ///< of a standard normal value
  /// Four of seven squares of white noise are so large once in 400 times.
  static constexpr double noisier = 6;
  static constexpr double largest = 9;  ///< a square of more is a jump, and counts as this one
  std::array<double, few> last_few_{};
  double mean_, least_, last_ = 0;
  std::size_t count_ = 0;
};

}  // namespace drydock::pipeline
