#include "hil/characterize/noise/step.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace drydock::characterize {
namespace {

/// The distinct values. Values that differ only by the rounding of conversions count as one.
std::vector<double> values_of(std::span<const double> readings) {
  std::vector<double> values(readings.begin(), readings.end());
  std::ranges::sort(values);
  if (values.empty()) return values;
  const double same = 1e-9 * std::max(std::abs(values.front()), std::abs(values.back()));
  const auto rest = std::unique(values.begin(), values.end(),
                                [same](double a, double b) { return b - a <= same; });
  values.erase(rest, values.end());
  return values;
}

}  // namespace

std::optional<double> quantisation_step(std::span<const double> readings) {
  constexpr std::size_t fewest_values = 3, fewest_readings_a_value = 4;
  const auto values = values_of(readings);
  if (values.size() < fewest_values || values.size() * fewest_readings_a_value > readings.size())
    return std::nullopt;
  double step = values[1] - values[0];
  for (std::size_t i = 1; i < values.size(); ++i) step = std::min(step, values[i] - values[i - 1]);
  // Counts steps from value to value. Each count improves the step for the next one.
  double steps = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double gap = values[i] - values[i - 1];
    steps += std::round(gap / step);
    step = (values[i] - values[0]) / steps;
  }
  constexpr double largest_misfit = 0.1;  // fraction of a step, rms; values without a grid would
                                          // have 0.29
  double squares = 0;
  for (const double value : values) {
    const double place = (value - values[0]) / step;
    squares += (place - std::round(place)) * (place - std::round(place));
  }
  if (std::sqrt(squares / static_cast<double>(values.size())) > largest_misfit) return std::nullopt;
  return step;
}

}  // namespace drydock::characterize
