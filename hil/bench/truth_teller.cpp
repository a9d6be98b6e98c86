#include "hil/bench/truth_teller.hpp"

#include "estimators/host/bus_estimates.hpp"

namespace drydock::bench {

namespace {

/// As fine as a viewer draws. An estimate that comes with a truth has the truth of its own time.
constexpr std::chrono::milliseconds truth_interval{40};

pipeline::NavigationEstimate as_estimate(const motion::Truth& truth) {
  pipeline::NavigationEstimate estimate;
  estimate.valid_at = truth.at;
  estimate.position = {truth.latitude_rad, truth.longitude_rad, truth.height_m};
  estimate.velocity_ned = truth.velocity_ned;
  estimate.body_to_ned = truth.body_to_ned;
  return estimate;
}

}  // namespace

void TruthTeller::on_estimate(const host::Estimate& estimate) {
  const Stamp at = estimate.attitude.valid_at;
  if (at >= last_ && at - last_ < truth_interval) return;
  last_ = at;
  const auto truth = as_estimate(truth_.at(at));
  if (!origin_) origin_ = truth.position;
  to_.on_truth(host::bus_estimate(truth, *origin_));
}

}  // namespace drydock::bench
