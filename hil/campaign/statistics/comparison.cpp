#include "hil/campaign/statistics/comparison.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

#include "hil/campaign/statistics/quantile.hpp"

namespace drydock::campaign {
namespace {

double median_of(const std::vector<double>& sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

std::vector<double> evenly_taken(std::span<const double> values) {
  constexpr std::size_t most = 1000;
  const std::size_t count = std::min(values.size(), most);
  std::vector<double> taken(count);
  for (std::size_t i = 0; i < count; ++i) taken[i] = values[i * values.size() / count];
  return taken;
}

/// How many differences lie outside of the bound on each side.
double ranks_outside(double n, double m, double confidence) {
  const double z = quantile(boost::math::normal_distribution<>(), (1 + confidence) / 2);
  return std::floor(n * m / 2 - z * std::sqrt(n * m * (n + m + 1) / 12));
}

}  // namespace

Shift paired_shift(std::span<const double> earlier, std::span<const double> later,
                   double confidence) {
  std::vector<double> differences(earlier.size());
  for (std::size_t i = 0; i < earlier.size(); ++i) differences[i] = later[i] - earlier[i];
  std::ranges::sort(differences);
  const auto bounds = quantile_of(differences, 0.5, confidence);
  return {bounds.low, bounds.high, median_of(differences)};
}

Shift unpaired_shift(std::span<const double> earlier, std::span<const double> later,
                     double confidence) {
  const auto before = evenly_taken(earlier), after = evenly_taken(later);
  std::vector<double> differences;
  differences.reserve(before.size() * after.size());
  for (const double b : before)
    for (const double a : after) differences.push_back(a - b);
  std::ranges::sort(differences);
  Shift shift{.median = median_of(differences)};
  const double outside = ranks_outside(static_cast<double>(before.size()),
                                       static_cast<double>(after.size()), confidence);
  if (outside < 1) return shift;
  const auto k = static_cast<std::size_t>(outside);
  shift.low = differences[k - 1];
  shift.high = differences[differences.size() - k];
  return shift;
}

}  // namespace drydock::campaign
