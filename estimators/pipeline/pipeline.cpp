#include "estimators/pipeline/pipeline.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

namespace drydock::pipeline {

using measurement::Measurement;
using measurement::Stamp;

Pipeline::Pipeline(const PipelineOptions& options, EstimateListener& listener,
                   std::vector<std::unique_ptr<Estimator>> estimators)
    : window_(options.reorder_window),
      max_gap_(options.max_imu_gap),
      listener_(&listener),
      estimators_(std::move(estimators)),
      missing_(estimators_.size(), MissingEstimates(window_ + max_gap_)),
      buffer_(options.reorder_capacity) {}

void Pipeline::receive(const Measurement& measurement) {
  ++of(measurement::origin_of(measurement).device).received;
  std::visit(
      [this](const auto& m) {
        if constexpr (std::is_constructible_v<Sample, decltype(m)>) {
          order(m);
        } else {
          count(m.origin.device, Outcome::unused);
        }
      },
      measurement);
}

void Pipeline::advance(Stamp now) {
  latest_ = now;
  newest_ = std::max(newest_, now);
  release();
  for (const auto& estimator : estimators_) estimator->advance(newest_ - window_, *listener_);
  note_missing();
}

void Pipeline::flush() {
  while (!buffer_.empty()) run(buffer_.pop());
  for (const auto& estimator : estimators_) estimator->finish(*listener_);
  note_missing();
}

EstimatorStatus Pipeline::status(std::size_t estimator) const {
  EstimatorStatus status = estimators_[estimator]->status();
  status.missing = missing_[estimator].count(latest_, status);
  return status;
}

void Pipeline::note_missing() {
  for (std::size_t i = 0; i < estimators_.size(); ++i) missing_[i].note(estimators_[i]->status());
}

void Pipeline::order(const Sample& sample) {
  const Stamp at = latest_ = origin_of(sample).valid_at;
  if (window_ == std::chrono::nanoseconds::zero()) return run(sample);
  if (buffer_.full()) {
    ++overflows_;
    run(buffer_.pop());
  }
  buffer_.push(sample);
  newest_ = std::max(newest_, at);
  release();
}

void Pipeline::release() {
  // Strictly older: a measurement that is exactly `window_` late still gets its place.
  while (!buffer_.empty() && newest_ - buffer_.oldest() > window_) run(buffer_.pop());
}

void Pipeline::run(const Sample& sample) {
  if (is_left_out(origin_of(sample))) return count(origin_of(sample).device, Outcome::left_out);
  Outcome best = Outcome::unused;
  std::visit(
      [&](const auto& s) {
        for (const auto& estimator : estimators_) {
          best = std::min(best, estimator->take(s, *listener_));
        }
      },
      sample);
  note_missing();
  count(origin_of(sample).device, best);
}

void Pipeline::count(std::uint16_t device, Outcome outcome) {
  DeviceCounters& counters = of(device);
  switch (outcome) {
    case Outcome::accepted: ++counters.accepted; break;
    case Outcome::delayed: ++counters.delayed; break;
    case Outcome::late: ++counters.late; break;
    case Outcome::refused: ++counters.refused; break;
    case Outcome::unused: ++counters.unused; break;
    case Outcome::left_out: ++counters.left_out; break;
  }
}

void Pipeline::leave_out(std::uint16_t device, bool left_out, Stamp from) {
  if (device >= left_out_.size()) left_out_.resize(device + 1u);
  if (left_out_[device].now != left_out) left_out_[device] = {left_out, from};
}

void Pipeline::doubt(std::uint16_t device, bool doubted) {
  for (const auto& estimator : estimators_) estimator->doubt(device, doubted);
}

bool Pipeline::left_out(std::uint16_t device) const {
  return device < left_out_.size() && left_out_[device].now;
}

bool Pipeline::is_left_out(const measurement::Origin& origin) const {
  if (origin.device >= left_out_.size()) return false;
  const LeftOut& state = left_out_[origin.device];
  return state.now == (origin.valid_at >= state.since);
}

bool Pipeline::valid(std::size_t estimator, Stamp now) const {
  const EstimatorStatus& status = estimators_[estimator]->status();
  return status.valid && status.state == EstimatorState::running &&
         now - status.last_estimate <= window_ + std::max(max_gap_, status.longest_silence);
}

DeviceCounters& Pipeline::of(std::uint16_t device) {
  if (device >= counters_.size()) counters_.resize(device + 1u);
  return counters_[device];
}

}  // namespace drydock::pipeline
