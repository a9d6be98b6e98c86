#include "hil/characterize/noise/steadiness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace drydock::characterize {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::vector<double> means_of_seconds(std::span<const double> readings, double period_s) {
  const auto length = std::max<std::size_t>(1, static_cast<std::size_t>(std::round(1 / period_s)));
  std::vector<double> means;
  for (std::size_t i = 0; i + length <= readings.size(); i += length) {
    double sum = 0;
    for (std::size_t k = i; k < i + length; ++k) sum += readings[k];
    means.push_back(sum / static_cast<double>(length));
  }
  return means;
}

}  // namespace

Steadiness steadiness_of(std::span<const double> readings, double period_s, double change) {
  const auto means = means_of_seconds(readings, period_s);
  if (means.size() < 2) return {};
  std::vector<double> steps;
  for (std::size_t i = 1; i < means.size(); ++i) steps.push_back(std::abs(means[i] - means[i - 1]));
  constexpr double sigma_of_median = 1.4826 / 1.4142135623730951;  // for the differences of two
                                                                   // normal variables
  constexpr double sigmas = 6, share = 0.01;
  const double bound = std::max(change, sigmas * sigma_of_median * median(std::move(steps)));
  const double middle = median(means);
  Steadiness found;
  std::size_t far = 0;
  for (const double mean : means) {
    far += std::abs(mean - middle) > bound ? 1 : 0;
    found.change = std::max(found.change, std::abs(mean - middle));
  }
  found.steady = static_cast<double>(far) <= share * static_cast<double>(means.size());
  return found;
}

}  // namespace drydock::characterize
