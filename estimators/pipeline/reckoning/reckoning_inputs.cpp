#include <cmath>

#include "estimators/pipeline/reckoning/dead_reckoning_estimator.hpp"

/// What dead reckoning takes beside speeds and fixes: attitude, depth.
namespace drydock::pipeline {

Outcome DeadReckoningEstimator::take(const measurement::AttitudeSample& sample, EstimateListener&) {
  if (!is_of(options_.heading, sample.origin)) return Outcome::unused;
  const bool tells_heading = sample.true_heading_rad || sample.heading_rad;
  const auto taken = angles_.take(sample);
  note(taken, sample.origin.valid_at);
  if (!tells_heading) return taken.tilt ? Outcome::accepted : Outcome::unused;
  if (!taken.heading) return Outcome::refused;
  if (!begun_at_) begun_at_ = sample.origin.valid_at;
  note_fed_by(options_.heading);
  return Outcome::accepted;
}

void DeadReckoningEstimator::note(const ReckoningAttitude::Taken& taken, Stamp at) {
  status_.wild += static_cast<std::uint64_t>(taken.wild);
  attitude_ = angles_.at(at);
  if (taken.heading && last_) turned_.turn_to(angles_.heading_rad(), at);
  if (!taken.stepped_rad) return;
  filter_.doubt_heading(*taken.stepped_rad);
}

Outcome DeadReckoningEstimator::take(const measurement::DepthSample& sample, EstimateListener&) {
  if (!is_of(options_.depth, sample.origin) || !sample.depth_m) return Outcome::unused;
  if (!std::isfinite(*sample.depth_m)) return Outcome::refused;
  depth_m_ = *sample.depth_m;
  depth_at_ = sample.origin.valid_at;
  note_fed_by(options_.depth);
  return Outcome::accepted;
}

}  // namespace drydock::pipeline
