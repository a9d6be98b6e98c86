#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace drydock::summary {

/// Root mean square and largest of errors. An error that is NaN does not count: the estimate does
/// not give that quantity. Without any error both are NaN.
class ErrorSum {
 public:
  void add(double error) { add_square(error * error, std::abs(error)); }
  /// `square`: of the length of an error, which is `length`.
  void add_square(double square, double length) {
    if (!std::isfinite(square)) return;
    ++count_;
    sum_ += square;
    largest_ = std::max(largest_, length);
  }
  std::uint64_t count() const { return count_; }
  double mean() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : none; }
  double rms() const { return std::sqrt(mean()); }
  double largest() const { return count_ > 0 ? largest_ : none; }

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t count_ = 0;
  double sum_ = 0, largest_ = 0;
};

}  // namespace drydock::summary
