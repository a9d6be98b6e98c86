#include "hil/scorecard/reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::scorecard {
namespace {

/// The distance of a number from the straight line between `before` and `after`.
double off_line(const Series& series, const Sample& before, const Sample& at, const Sample& after) {
  const double span = after.valid_s - before.valid_s;
  const double share = span > 0 ? (at.valid_s - before.valid_s) / span : 0;
  const double line = before.value + share * difference(series, before.value, after.value);
  return std::abs(difference(series, line, at.value));
}

}  // namespace

double difference(const Series& series, double a, double b) {
  return series.angle ? std::remainder(b - a, 2 * std::numbers::pi) : b - a;
}

Reference::Reference(RunRecord run) : run_(std::move(run)) {
  for (auto& device : run_.devices) {
    auto& scales = scales_.emplace_back();
    for (auto& [key, series] : device.series) {
      std::ranges::stable_sort(series.samples, {}, &Sample::valid_s);
      scales[key] = scale_of(series);
    }
  }
}

Reference::Scale Reference::scale_of(const Series& series) {
  const auto& samples = series.samples;
  std::vector<double> steps;
  for (std::size_t i = 1; i < samples.size(); ++i)
    steps.push_back(samples[i].valid_s - samples[i - 1].valid_s);
  if (steps.empty()) return {};
  std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
  const double period_s = steps[steps.size() / 2];
  double most = 0, largest = 0;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    largest = std::max(largest, std::abs(samples[i].value));
    if (samples[i + 1].valid_s - samples[i - 1].valid_s > 3 * period_s) continue;
    most = std::max(most, off_line(series, samples[i - 1], samples[i], samples[i + 1]));
  }
  constexpr double arithmetic = 1e-9, clock_s = 0.005;  // clock_s: resolution of the time of
                                                        // validity on the wire
  const double least = series.role == Role::clock ? clock_s : arithmetic * largest;
  return {2 * most + least, period_s};
}

double Reference::period_s(std::size_t device, std::uint32_t series) const {
  return scales_.at(device).at(series).period_s;
}

std::optional<Reference::Expected> Reference::at(std::size_t device, std::uint32_t key,
                                                 double valid_s) const {
  const auto found = run_.devices.at(device).series.find(key);
  if (found == run_.devices.at(device).series.end()) return {};
  const auto& series = found->second;
  const Scale& scale = scales_.at(device).at(key);
  const double reach = 1.5 * scale.period_s;
  const auto after = std::ranges::lower_bound(series.samples, valid_s, {}, &Sample::valid_s);
  const bool has_after = after != series.samples.end() && after->valid_s - valid_s <= reach;
  const bool has_before =
      after != series.samples.begin() && valid_s - std::prev(after)->valid_s <= reach;
  if (!has_after && !has_before) return {};
  if (!has_after) return Expected{std::prev(after)->value, scale.tolerance};
  if (!has_before) return Expected{after->value, scale.tolerance};
  const auto before = std::prev(after);
  const double span = after->valid_s - before->valid_s;
  const double share = span > 0 ? (valid_s - before->valid_s) / span : 0;
  return Expected{before->value + share * difference(series, before->value, after->value),
                  scale.tolerance};
}

bool Reference::sound(std::size_t device, std::uint32_t key, const Sample& sample) const {
  const auto expected = at(device, key, sample.valid_s);
  if (!expected) return false;
  const Series& series = run_.devices[device].series.at(key);
  return std::abs(difference(series, expected->value, sample.value)) <= expected->tolerance;
}

}  // namespace drydock::scorecard
