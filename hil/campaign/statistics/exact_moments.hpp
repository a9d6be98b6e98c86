#pragma once

#include <cstddef>

#include "hil/campaign/statistics/exact_sum.hpp"

namespace drydock::campaign {

/// Mean and variance that do not depend on the order or the grouping of the numbers, to the last
/// bit. Numbers up to 1e140 in magnitude.
class ExactMoments {
 public:
  void add(double x) {
    ++count_;
    sum_.add(x);
    squares_.add_product(x, x);
  }
  void merge(const ExactMoments& other) {
    count_ += other.count_;
    sum_.add(other.sum_);
    squares_.add(other.squares_);
  }

  std::size_t count() const { return count_; }
  double mean() const { return sum_.rounded() / static_cast<double>(count_); }
  /// Sum of the squared distances from the mean: the difference of two large sums is exact.
  double squared_distances() const {
    ExactSum scaled, count;
    count.add(-static_cast<double>(count_));
    scaled.subtract_product(count, squares_);
    scaled.subtract_product(sum_, sum_);
    return scaled.rounded() / static_cast<double>(count_);
  }
  double variance() const { return squared_distances() / static_cast<double>(count_ - 1); }

 private:
  std::size_t count_ = 0;
  ExactSum sum_, squares_;
};

}  // namespace drydock::campaign
