#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace drydock::consistency {

/// The residuals of which a test learns. Less than half of them may be of a fault: it moves neither
/// their median nor much of their scatter. No allocation.
template <std::size_t Most>
class FirstResiduals {
 public:
  void clear() { count_ = 0; }
  void add(double residual) {
    if (count_ < Most) all_[count_++] = residual;
  }

  double median() const { return middle(all_); }

  /// About the median. Beyond three deviations it counts as three; a deviation is 1.4826 of the
  /// median one, as of Gaussian residuals (Huber 1981, 5.1).
  double mean_square() const {
    const double at = median();
    auto away = all_;
    for (double& one : away) one = std::abs(one - at);
    const double most = 3 * 1.4826 * middle(away);
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i)
      sum += std::min(away[i], most) * std::min(away[i], most);
    return count_ == 0 ? 0 : sum / static_cast<double>(count_);
  }

 private:
  double middle(std::array<double, Most> values) const {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(count_ / 2);
    std::nth_element(values.begin(), place, values.begin() + static_cast<std::ptrdiff_t>(count_));
    return count_ == 0 ? 0 : *place;
  }

  std::array<double, Most> all_{};
  std::size_t count_ = 0;
};

}  // namespace drydock::consistency
