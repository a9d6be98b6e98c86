#include "hil/bench/truth_teller.hpp"

#include "estimators/host/bus_estimates.hpp"
#include "hil/bench/truth_estimate.hpp"

namespace drydock::bench {

namespace {

/// As fine as a viewer draws. An estimate that comes with a truth has the truth of its own time.
constexpr std::chrono::milliseconds truth_interval{40};

/// Ticks leave no such hole between truths, so a longer one is a step of the host's clock.
constexpr std::chrono::seconds longest_hole{10};

}  // namespace

void TruthTeller::on_estimate(const host::Estimate& estimate) {
  const Stamp at = estimate.attitude.valid_at;
  const bool is_told = origin_ ? at <= newest_ : at < newest_;
  if (is_told && newest_ - at < longest_hole) return;  // of an estimator that is later than another
  if (at >= last_ && at - last_ < truth_interval) return;
  if (origin_) fill(at);
  last_ = at;
  tell(at);
}

/// Up to `end`, but not so near to it that the next truth would follow at once.
void TruthTeller::fill(Stamp end) {
  if (end - newest_ > longest_hole) newest_ = end;
  for (Stamp at = newest_ + truth_interval; at < end - truth_interval / 2; at += truth_interval)
    tell(at);
}

void TruthTeller::tell(Stamp at) {
  newest_ = at;
  const auto truth = as_estimate(truth_.at(at));
  if (!origin_) origin_ = truth.position;
  to_.on_truth(host::bus_estimate(truth, *origin_));
}

}  // namespace drydock::bench
