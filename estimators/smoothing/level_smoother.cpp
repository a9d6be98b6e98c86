#include "estimators/smoothing/level_smoother.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "estimators/smoothing/rts.hpp"

namespace drydock::smoothing {
namespace {

constexpr double same_time_s = 1e-4;

using LevelStep = RtsStep<level_size>;

/// The order of the readings by the times at which they were true.
struct Order {
  std::vector<double> times_s;  ///< by reading
  std::vector<std::size_t> order;

  Order(const Dive& dive, const SensorModels& sensors)
      : times_s(dive.readings.size()), order(dive.readings.size()) {
    for (std::size_t i = 0; i < times_s.size(); ++i) {
      const Reading& reading = dive.readings[i];
      const double latency =
          reading.device < sensors.size() ? sensors[reading.device].latency_s : 0;
      times_s[i] = reading.time_s - latency;
    }
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return times_s[i]; });
  }

  double time_s(std::size_t k) const { return times_s[order[k]]; }
  /// The end of the epoch that begins at `k`: its readings were true at the same time.
  std::size_t end_of_epoch(std::size_t k) const {
    const double now = time_s(k);
    while (k < order.size() && !(time_s(k) - now > same_time_s)) ++k;
    return k;
  }
  std::size_t epochs() const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < order.size(); k = end_of_epoch(k)) ++count;
    return count;
  }
};

/// Looks ahead of the filter, which goes through the readings in their order.
class Lookout {
 public:
  Lookout(const Dive& dive, const Order& by_time) : dive_(dive), by_time_(by_time) {}

  /// From `now_s` on, for the epoch that begins at `k`. `k` does not decrease.
  HeadingAhead from(std::size_t k, double now_s) {
    find(heading_, k, [](const Reading& r) { return r.quantity == Quantity::heading; });
    if (heading_ == by_time_.order.size()) return {};
    find(speed_, k, [](const Reading& r) {
      return r.quantity == Quantity::bottom || r.quantity == Quantity::log;
    });
    return {&reading(heading_), by_time_.time_s(heading_) - now_s, speed()};
  }

 private:
  const Reading& reading(std::size_t k) const { return dive_.readings[by_time_.order[k]]; }
  void find(std::size_t& at, std::size_t k, auto wanted) const {
    at = std::max(at, k);
    while (at < by_time_.order.size() &&
           (!wanted(reading(at)) || std::isnan(reading(at).value.x())))
      ++at;
  }
  double speed() const {
    if (speed_ == by_time_.order.size()) return 0;
    const auto& v = reading(speed_).value;
    return std::isnan(v.y()) ? std::abs(v.x()) : v.head<2>().norm();
  }

  const Dive& dive_;
  const Order& by_time_;
  std::size_t heading_ = 0, speed_ = 0;
};

using AfterEpoch =
    std::function<void(double time_s, const LevelStep& step, const LevelFilter& filter)>;

/// One pass forward; `after` may be empty.
Residuals pass(const Dive& dive, const LevelOptions& options, const Order& by_time,
               const AfterEpoch& after) {
  Residuals residuals(dive.readings.size());
  LevelFilter filter(options);
  Lookout lookout(dive, by_time);
  double now = by_time.order.empty() ? 0 : by_time.time_s(0);
  for (std::size_t k = 0; k < by_time.order.size();) {
    const double time = by_time.time_s(k);
    LevelStep step;
    step.transition = filter.propagate(time - now, lookout.from(k, now));
    if (after) step.predicted = filter.covariance();
    now = time;
    const Tilt tilt = tilt_at(dive.tilts, now);
    for (const std::size_t end = by_time.end_of_epoch(k); k < end; ++k) {
      const std::size_t i = by_time.order[k];
      residuals[i] = filter.update(dive.readings[i], tilt);
    }
    if (!after) continue;
    step.filtered = filter.covariance();
    step.correction = filter.correction();
    after(now, step, filter);
  }
  return residuals;
}

}  // namespace

Residuals level_residuals(const Dive& dive, const LevelOptions& options) {
  return pass(dive, options, Order(dive, options.sensors), {});
}

Track smooth_level(const Dive& dive, const LevelOptions& options) {
  Track track;
  std::vector<LevelStep> steps;
  std::vector<LevelState> states;
  const Order by_time(dive, options.sensors);
  const std::size_t epochs = by_time.epochs();
  steps.reserve(epochs);  // 5.4 kB each: moving them as the vector grows took half of the time
  states.reserve(epochs);
  track.filtered.reserve(epochs);
  const auto keep = [&](double time_s, const LevelStep& step, const LevelFilter& filter) {
    steps.push_back(step);
    states.push_back(filter.state());
    track.bottom_scale = filter.state().bottom_scale;
    track.bottom_scale_sigma = std::sqrt(filter.covariance()(bottom_scale_part, bottom_scale_part));
    track.filtered.push_back(
        point_of(time_s, filter.state(), filter.covariance(), tilt_at(dive.tilts, time_s)));
  };
  track.residuals = pass(dive, options, by_time, keep);
  const auto results = smooth<level_size>(std::span<const LevelStep>(steps));
  track.smoothed.reserve(results.size());
  for (std::size_t k = 0; k < results.size(); ++k) {
    const double time_s = track.filtered[k].time_s;
    states[k].add(results[k].correction);
    track.smoothed.push_back(
        point_of(time_s, states[k], results[k].covariance, tilt_at(dive.tilts, time_s)));
  }
  return track;
}

LevelState level_start(const Dive& dive, const frame::Position& otherwise) {
  LevelState start;
  start.position = otherwise;
  const auto first = [&](Quantity quantity) -> const Reading* {
    const auto found = std::ranges::find(dive.readings, quantity, &Reading::quantity);
    return found == dive.readings.end() ? nullptr : &*found;
  };
  if (const auto* fix = first(Quantity::fix)) {
    start.position.latitude_rad = fix->value.x();
    start.position.longitude_rad = fix->value.y();
    if (std::isfinite(fix->value.z())) start.position.height_m = fix->value.z();
  }
  if (const auto* heading = first(Quantity::heading))
    start.heading_rad = frame::wrap_pi(heading->value.x());
  if (const auto* depth = first(Quantity::depth)) start.position.height_m = -depth->value.x();
  return start;
}

}  // namespace drydock::smoothing
