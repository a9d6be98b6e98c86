#include "estimators/navigation/innovation_window.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace drydock::navigation {

double chi_square_tail(double x, int pairs) {
  double term = std::exp(-x / 2), sum = 0;
  for (int i = 1; i <= pairs; ++i) {
    sum += term;
    term *= x / 2 / i;
  }
  return sum;
}

double chi_square_limit(double probability, int pairs) {
  double low = 0, high = 1000;
  while (high - low > 1e-9) {
    const double middle = (low + high) / 2;
    (chi_square_tail(middle, pairs) > probability ? low : high) = middle;
  }
  return high;
}

void InnovationWindow::add(double normalised) {
  constexpr std::uint32_t all = (1U << size) - 1;
  // This comparison is false for NaN too.
  const bool inside = std::abs(normalised) <= outlier_sigmas;
  outliers_ = (outliers_ << 1U | (inside ? 0U : 1U)) & all;
  if (inside) values_[count_++ % size] = normalised;
}

double InnovationWindow::squares() const {
  return std::inner_product(values_.begin(), values_.end(), values_.begin(), 0.0);
}

double InnovationWindow::mean() const {
  const double n = std::clamp<double>(count_, 1, size);
  return std::accumulate(values_.begin(), values_.end(), 0.0) / std::sqrt(n);
}

int InnovationWindow::outliers() const { return std::popcount(outliers_); }

bool InnovationWindow::contradicts() const {
  static const double squares_limit = chi_square_limit(false_alarm, size / 2);
  constexpr double mean_limit = 5.3267;  // two-sided 1e-7
  return squares() > squares_limit || std::abs(mean()) > mean_limit || outliers() > most_outliers;
}

}  // namespace drydock::navigation
