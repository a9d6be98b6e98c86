#include "hil/motion/ordered/order_log.hpp"

#include <algorithm>

namespace drydock::motion {

using measurement::actuator_count;
using measurement::propeller_number;

OrderLog::OrderLog(const rig_config::VehicleConfig& vehicle, double speed_mps, Stamp start)
    : advance_m_(vehicle.propeller.advance_m), start_(start) {
  for (Series& series : series_) series.push_back({0, 0});
  series_[propeller_number].front().value = speed_mps / advance_m_;
}

void OrderLog::give(const measurement::ActuatorOrder& order, Stamp at) {
  const std::lock_guard lock(mutex_);
  const std::int64_t ns = (at - start_).count();
  const std::int64_t cycle = ns > 0 ? (ns + voyage_step_ns - 1) / voyage_step_ns : 0;
  const std::int64_t step = std::max(cycle, asked_ + 1);
  for (int number = 0; number < actuator_count; ++number) {
    const auto& value = value_of(order, number);
    if (!value) continue;
    Series& series = series_[static_cast<std::size_t>(number)];
    while (series.back().step >= step) series.pop_back();
    if (series.back().value != *value) series.push_back({step, *value});
  }
}

double OrderLog::value_at(const Series& series, std::int64_t step) {
  if (series.back().step <= step) return series.back().value;
  const auto later = std::ranges::upper_bound(series, step, {}, &Entry::step);
  return std::prev(later)->value;
}

Command OrderLog::command(std::int64_t step, const VehicleState&, AutopilotMemory&) const {
  const std::lock_guard lock(mutex_);
  asked_ = std::max(asked_, step);
  return {value_at(series_[0], step), value_at(series_[1], step), value_at(series_[2], step),
          advance_m_ * value_at(series_[propeller_number], step)};
}

}  // namespace drydock::motion
