#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace drydock::study {

/// Mean, standard deviation and root mean square of one error over the runs, at each of several
/// instants. If the runs are added in the same order, the result is equal to the last bit.
class Ensemble {
 public:
  explicit Ensemble(std::size_t instants) : sum_(instants), squares_(instants) {}

  /// Adds the error of one more run at every instant.
  void add(const std::vector<double>& error) {
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      sum_[i] += error[i];
      squares_[i] += error[i] * error[i];
    }
    ++runs_;
  }

  std::size_t runs() const { return runs_; }
  std::size_t instants() const { return sum_.size(); }
  double mean(std::size_t i) const { return sum_[i] / static_cast<double>(runs_); }
  double rms(std::size_t i) const { return std::sqrt(squares_[i] / static_cast<double>(runs_)); }

  /// About the ensemble's mean; divides by n, not n - 1.
  double deviation(std::size_t i) const {
    const double variance = squares_[i] / static_cast<double>(runs_) - mean(i) * mean(i);
    return std::sqrt(variance > 0 ? variance : 0);
  }

 private:
  std::vector<double> sum_, squares_;
  std::size_t runs_ = 0;
};

}  // namespace drydock::study
