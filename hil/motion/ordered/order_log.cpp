#include "hil/motion/ordered/order_log.hpp"

#include <algorithm>

#include "hil/motion/vehicle/helm.hpp"

namespace drydock::motion {

OrderLog::OrderLog(const std::vector<double>& first, Stamp start) : start_(start) {
  for (const double value : first) series_.push_back({{0, value}});
}

void OrderLog::give(std::size_t actuator, double value, Stamp at) {
  const std::lock_guard lock(mutex_);
  const std::int64_t ns = (at - start_).count();
  const std::int64_t cycle = ns > 0 ? (ns + voyage_step_ns - 1) / voyage_step_ns : 0;
  const std::int64_t step = std::max(cycle, asked_ + 1);
  Series& series = series_.at(actuator);
  while (series.back().step >= step) series.pop_back();
  if (series.back().value != value) series.push_back({step, value});
}

double OrderLog::value_at(const Series& series, std::int64_t step) {
  if (series.back().step <= step) return series.back().value;
  const auto later = std::ranges::upper_bound(series, step, {}, &Entry::step);
  return std::prev(later)->value;
}

void OrderLog::read(std::int64_t step, std::span<double> values) const {
  const std::lock_guard lock(mutex_);
  asked_ = std::max(asked_, step);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value_at(series_[i], step);
}

}  // namespace drydock::motion
