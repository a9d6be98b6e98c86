#include "hil/bench/truth_teller.hpp"

#include "estimators/host/bus_estimates.hpp"
#include "hil/bench/truth_estimate.hpp"

namespace drydock::bench {

namespace {

/// As fine as a viewer draws. An estimate that comes with a truth has the truth of its own time.
constexpr std::chrono::milliseconds truth_interval{40};

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
