#include "hil/twin/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drydock::twin {
namespace {

constexpr std::size_t fewest_values = 10;
constexpr std::size_t most_gaps = 100;
constexpr double long_gap_steps = 5;
constexpr std::size_t long_run = 3;
/// Neighbours of pure white noise seldom agree more than this many standard errors.
constexpr double by_chance = 3;

/// Several messages of one time are one step. 0: all samples have one time.
double median_step_s(std::span<const Error> errors) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < errors.size(); ++i)
    if (errors[i].valid_at > errors[i - 1].valid_at)
      steps.push_back(measurement::seconds(errors[i].valid_at - errors[i - 1].valid_at));
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

double autocovariance(std::span<const double> values, double mean, std::size_t lag) {
  double sum = 0;
  for (std::size_t i = lag; i < values.size(); ++i)
    sum += (values[i] - mean) * (values[i - lag] - mean);
  return sum / static_cast<double>(values.size() - lag);
}

/// Variance of white noise: a fourth difference has 1 + 16 + 36 + 16 + 1 times it.
double white_variance(std::span<const double> v) {
  double sum = 0;
  for (std::size_t i = 4; i < v.size(); ++i) {
    const double difference = v[i] - 4 * v[i - 1] + 6 * v[i - 2] - 4 * v[i - 3] + v[i - 4];
    sum += difference * difference;
  }
  return sum / static_cast<double>(v.size() - 4) / 70;
}

bool is_empty(const Error& error) { return error.of[0].array().isNaN().all(); }

std::vector<Gap> empty_runs_of(std::span<const Error> errors) {
  std::vector<Gap> runs;
  std::size_t length = 0;
  for (std::size_t i = 0; i <= errors.size() && runs.size() < most_gaps; ++i) {
    const bool empty = i < errors.size() && is_empty(errors[i]);
    if (!empty && length >= long_run)
      runs.push_back({errors[i - length].valid_at, errors[i - 1].valid_at});
    length = empty ? length + 1 : 0;
  }
  return runs;
}

/// The time in which c(1) decays by e, from the first lag at which it has; lags double.
double correlation_s(std::span<const double> values, double mean, double first, double step_s) {
  const std::size_t longest = values.size() / 4;
  double last = first;
  std::size_t lag = 1;
  while (lag < longest && last > first / std::exp(1.0)) {
    lag *= 2;
    last = autocovariance(values, mean, lag);
  }
  const double decay = std::log(first / std::max(last, 0.05 * first));
  return static_cast<double>(std::max<std::size_t>(lag - 1, 1)) * step_s / std::max(decay, 0.05);
}

}  // namespace

Timing timing_of(std::span<const Error> errors) {
  Timing timing;
  timing.samples = errors.size();
  if (errors.size() < 2) return timing;
  const double step = median_step_s(errors);
  if (!(step > 0)) return timing;
  timing.rate_hz = 1 / step;
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const double gap = measurement::seconds(errors[i].valid_at - errors[i - 1].valid_at);
    timing.longest_gap_s = std::max(timing.longest_gap_s, gap);
    if (gap <= 1.5 * step) continue;
    ++timing.outages;
    const auto lost = static_cast<std::uint64_t>(std::lround(gap / step)) - 1;
    timing.lost += lost;
    if (gap < long_gap_steps * step || timing.long_gaps.size() == most_gaps) continue;
    timing.long_gaps.push_back({errors[i - 1].valid_at, errors[i].valid_at});
    timing.lost_in_long_gaps += lost;
  }
  return timing;
}

std::optional<AxisNoise> noise_of(std::span<const double> values, double step_s) {
  if (values.size() < fewest_values) return {};
  AxisNoise noise;
  noise.values = values.size();
  const auto count = static_cast<double>(values.size());
  noise.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  const double variance = autocovariance(values, noise.mean, 0);
  const double next = autocovariance(values, noise.mean, 1);
  noise.sigma = std::sqrt(variance);
  const double white = white_variance(values);
  noise.white = std::sqrt(white);
  if (next < by_chance * variance / std::sqrt(count) || white >= variance) return noise;
  noise.slow = std::sqrt(variance - white);
  noise.correlation_s = correlation_s(values, noise.mean, next, step_s);
  return noise;
}

DeviceStatistics statistics_of(std::span<const Error> errors, rig_config::DeviceKind kind) {
  DeviceStatistics statistics;
  statistics.timing = timing_of(errors);
  statistics.empty = static_cast<std::uint64_t>(std::ranges::count_if(errors, is_empty));
  statistics.empty_runs = empty_runs_of(errors);
  const double step = statistics.timing.rate_hz > 0 ? 1 / statistics.timing.rate_hz : 0;
  for (const auto& quantity : characterize::quantities_of(kind)) {
    QuantityNoise noise{quantity, {}};
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      for (const auto& error : errors) {
        const double value = error.of.at(static_cast<std::size_t>(quantity.place))[axis];
        if (std::isfinite(value)) values.push_back(value);
      }
      noise.axes.at(static_cast<std::size_t>(axis)) = noise_of(values, step);
    }
    statistics.quantities.push_back(noise);
  }
  return statistics;
}

}  // namespace drydock::twin
