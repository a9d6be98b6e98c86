#include "hil/characterize/timing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace drydock::characterize {
namespace {

using measurement::Origin;
using measurement::seconds;

std::vector<double> arrivals_of(std::span<const Origin> origins) {
  std::vector<double> times;
  times.reserve(origins.size());
  for (const Origin& o : origins) times.push_back(seconds(o.received_at - origins[0].received_at));
  return times;
}

/// The device's clock against the arrivals: no buffer delays by so much.
constexpr double clock_jump_s = 3600;

/// Empty unless every sample has a device time, and the device's clock neither stands nor jumps.
std::vector<double> device_times_of(std::span<const Origin> origins) {
  std::vector<double> times;
  for (const Origin& o : origins) {
    if (!o.device_time) return {};
    times.push_back(seconds(*o.device_time - *origins[0].device_time));
    if (times.size() == 1) continue;
    const double step_s = times.back() - times[times.size() - 2];
    const double arrived_s = seconds(o.received_at - (&o - 1)->received_at);
    if (step_s <= 0 || std::abs(step_s - arrived_s) > clock_jump_s) return {};
  }
  return times;
}

double median_gap(const std::vector<double>& times) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < times.size(); ++i) gaps.push_back(times[i] - times[i - 1]);
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::ranges::nth_element(gaps, middle);
  return *middle;
}

/// From so many periods on nobody lost samples one by one: the sensor or the recorder paused.
constexpr double shortest_pause = 100;

/// The samples' numbers, and the first sample of each run between pauses.
struct Numbers {
  std::vector<double> of_samples;
  std::vector<std::size_t> runs{0};
  std::size_t outages = 0, lost = 0;
  double paused_s = 0;
};

Numbers numbered(const std::vector<double>& times, double period) {
  constexpr double longest_regular = 1.5;  // in periods
  Numbers numbers;
  numbers.of_samples.assign(times.size(), 0.0);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double periods = (times[i] - times[i - 1]) / period;
    double step = 1;
    if (periods > shortest_pause) {
      numbers.runs.push_back(i);
      numbers.paused_s += times[i] - times[i - 1];
    } else if (periods > longest_regular) {
      step = std::round(periods);
      ++numbers.outages;
      numbers.lost += static_cast<std::size_t>(step) - 1;
    }
    numbers.of_samples[i] = numbers.of_samples[i - 1] + step;
  }
  return numbers;
}

struct Line {
  double slope = 0, sigma = 0;  ///< sigma: standard deviation of the slope
  double rms = 0, largest = 0;  ///< residuals
};

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// One slope for all runs; each has a level of its own, since no period divides a pause.
Line fit_line(const std::vector<double>& x, const std::vector<double>& y,
              const std::vector<std::size_t>& runs) {
  std::vector<double> dx, dy;  // from the means of the run
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto end = r + 1 < runs.size() ? runs[r + 1] : x.size();
    const auto xs = std::span(x).subspan(runs[r], end - runs[r]);
    const auto ys = std::span(y).subspan(runs[r], end - runs[r]);
    const double mean_x = mean_of(xs), mean_y = mean_of(ys);
    for (const double value : xs) dx.push_back(value - mean_x);
    for (const double value : ys) dy.push_back(value - mean_y);
  }
  const double xx = std::inner_product(dx.begin(), dx.end(), dx.begin(), 0.0);
  Line line{.slope = std::inner_product(dx.begin(), dx.end(), dy.begin(), 0.0) / xx};
  double squares = 0;
  for (std::size_t i = 0; i < dx.size(); ++i) {
    const double rest = dy[i] - line.slope * dx[i];
    squares += rest * rest;
    line.largest = std::max(line.largest, std::abs(rest));
  }
  const auto n = static_cast<double>(x.size());
  line.rms = std::sqrt(squares / n);
  line.sigma = std::sqrt(squares / std::max(1.0, n - 1 - static_cast<double>(runs.size())) / xx);
  return line;
}

Estimate rate_of(const Line& period) {
  return normal_estimate(1 / period.slope, period.sigma / (period.slope * period.slope));
}

/// Wilson's confidence interval of a share. Of none and of all it has an end that no rounding may
/// move.
Estimate share(std::size_t cases, std::size_t of) {
  const auto n = static_cast<double>(of);
  const double p = static_cast<double>(cases) / n, zz = z_95 * z_95;
  const double middle = (p + zz / (2 * n)) / (1 + zz / n);
  const double half = z_95 / (1 + zz / n) * std::sqrt(p * (1 - p) / n + zz / (4 * n * n));
  return {p, cases == 0 ? 0 : middle - half, cases == of ? 1 : middle + half};
}

void add_latency(TimingFigures& figures, std::span<const Origin> origins) {
  const auto n = static_cast<double>(origins.size());
  const auto latency = [](const Origin& o) { return seconds(o.received_at - o.valid_at); };
  double squares = 0;
  for (const Origin& o : origins) {
    figures.latency_s += latency(o) / n;
    figures.largest_latency_s = std::max(figures.largest_latency_s, latency(o));
  }
  for (const Origin& o : origins)
    squares += (latency(o) - figures.latency_s) * (latency(o) - figures.latency_s);
  figures.latency_spread_s = std::sqrt(squares / n);
}

}  // namespace

std::optional<TimingFigures> timing_of(std::span<const Origin> origins) {
  constexpr std::size_t fewest = 10;
  if (origins.size() < fewest) return std::nullopt;
  const auto arrivals = arrivals_of(origins), device_times = device_times_of(origins);
  // Arrivals in bursts have no regular gaps, but the device's own times have.
  const auto& gaps_of = device_times.empty() ? arrivals : device_times;
  const double period = median_gap(gaps_of);
  if (!(period > 0)) return std::nullopt;
  const Numbers numbers = numbered(gaps_of, period);
  const Line line = fit_line(numbers.of_samples, arrivals, numbers.runs);
  if (!(line.slope > 0)) return std::nullopt;
  TimingFigures figures;
  figures.samples = origins.size();
  figures.rate_hz = rate_of(line);
  if (!device_times.empty())
    figures.device_rate_hz = rate_of(fit_line(numbers.of_samples, device_times, numbers.runs));
  figures.jitter_s = line.rms;
  figures.largest_jitter_s = line.largest;
  figures.outages = numbers.outages;
  figures.lost = numbers.lost;
  figures.pauses = numbers.runs.size() - 1;
  figures.paused_s = numbers.paused_s;
  figures.outage_probability = share(numbers.outages, origins.size());
  if (numbers.outages > 0)
    figures.mean_outage = static_cast<double>(numbers.lost) / static_cast<double>(numbers.outages);
  add_latency(figures, origins);
  return figures;
}

}  // namespace drydock::characterize
