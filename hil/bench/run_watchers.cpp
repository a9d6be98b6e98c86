#include "hil/bench/run_watchers.hpp"

namespace drydock::bench {

namespace {

/// As fine as a viewer draws. An estimate that comes with a truth has the truth of its own time.
constexpr std::chrono::milliseconds truth_interval{40};

pipeline::NavigationEstimate as_estimate(const motion::Truth& truth, std::size_t index) {
  pipeline::NavigationEstimate estimate;
  estimate.valid_at = truth.at;
  estimate.estimator = static_cast<std::uint16_t>(index);
  estimate.position = {truth.latitude_rad, truth.longitude_rad, truth.height_m};
  estimate.velocity_ned = truth.velocity_ned;
  estimate.body_to_ned = truth.body_to_ned;
  return estimate;
}

}  // namespace

void RunWatchers::note_truth(measurement::Stamp at) {
  if (truth_ == nullptr || (at >= last_truth_ && at - last_truth_ < truth_interval)) return;
  last_truth_ = at;
  const auto truth = as_estimate(truth_->at(at), truth_index_);
  all.note(host::bus_attitude(pipeline::attitude_of(truth)), truth_index_);
  all.note(to_bus_(truth), truth_index_);
}

void RunWatchers::note(const pipeline::AttitudeEstimate& estimate) {
  if (all.empty()) return;
  note_truth(estimate.valid_at);
  all.note(host::bus_attitude(estimate), estimate.estimator);
}

void RunWatchers::note(const pipeline::NavigationEstimate& estimate) {
  if (all.empty()) return;
  note_truth(estimate.valid_at);
  all.note(host::bus_attitude(pipeline::attitude_of(estimate)), estimate.estimator);
  all.note(to_bus_(estimate), estimate.estimator);
}

void RunWatchers::note(const pipeline::InnovationReport& innovation) {
  if (!all.empty()) all.note(host::bus_innovation(innovation));
}

void tell_faults_to(host::Watchers& all, const std::vector<fault::FaultNow>& faults,
                    measurement::Stamp now) {
  std::vector<bus::Fault> told;
  told.reserve(faults.size());
  for (const fault::FaultNow& f : faults)
    told.push_back({f.device, f.name, f.words, f.since, f.until});
  all.note(told, now);
}

}  // namespace drydock::bench
