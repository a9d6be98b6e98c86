#include "estimators/pipeline/external_estimator.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::pipeline {
namespace {

/// Before more measurements than this come in one step, it allocates nothing.
constexpr std::size_t usual_samples = 4096, usual_answers = 256;

const Integrity& integrity_of(const OutsideEstimate& estimate) {
  return std::visit([](const auto& e) -> const Integrity& { return e.integrity; }, estimate);
}

}  // namespace

Stamp valid_at(const OutsideEstimate& estimate) {
  return std::visit([](const auto& e) { return e.valid_at; }, estimate);
}

ExternalEstimator::ExternalEstimator(Seat seat, const ExternalOptions& options)
    : index_(seat.index), step_(options.step) {
  if (options.connect) peer_ = options.connect();
  status_.state = EstimatorState::waiting_for_answers;
  samples_.reserve(usual_samples);
  answers_.reserve(usual_answers);
}

template <class Measurement>
Outcome ExternalEstimator::keep(const Measurement& measurement, EstimateListener& listener) {
  if (!peer_) return Outcome::unused;
  const Stamp at = measurement.origin.valid_at;
  if (!step_end_) begin(at);
  at >= *step_end_ ? close_step(at, listener) : hear(listener);
  samples_.emplace_back(measurement);
  newest_ = std::max(newest_, at);
  return Outcome::accepted;
}

void ExternalEstimator::begin(Stamp at) {
  newest_ = oldest_allowed_ = at;
  step_end_ = at + step_;
}

/// The next step is that of `at`: a silence of all sensors is one step and not many empty ones.
void ExternalEstimator::close_step(Stamp at, EstimateListener& listener) {
  const Stamp now = *step_end_ + (at - *step_end_) / step_ * step_;
  hand_over(now);
  tell(listener);
  step_end_ = now + step_;
}

void ExternalEstimator::hand_over(Stamp now) {
  peer_->exchange({++steps_, now, samples_}, answers_);
  newest_ = std::max(newest_, now);
  samples_.clear();
}

void ExternalEstimator::advance(Stamp now, EstimateListener& listener) {
  if (!peer_ || !step_end_) return;
  now >= *step_end_ ? close_step(now, listener) : hear(listener);
}

void ExternalEstimator::hear(EstimateListener& listener) {
  peer_->poll(answers_);
  tell(listener);
}

void ExternalEstimator::finish(EstimateListener& listener) {
  if (!peer_) return;
  if (!samples_.empty()) hand_over(*step_end_);
  peer_->finish(answers_);
  tell(listener);
}

void ExternalEstimator::tell(EstimateListener& listener) {
  for (OutsideEstimate& estimate : answers_) tell(estimate, listener);
  answers_.clear();
  if (!peer_->account().failure.empty()) status_.state = EstimatorState::lost;
}

void ExternalEstimator::tell(OutsideEstimate& estimate, EstimateListener& listener) {
  if (!is_in_time(estimate)) return peer_->refuse(estimate, newest_);
  oldest_allowed_ = status_.last_estimate = valid_at(estimate);
  ++status_.estimates;
  status_.state = EstimatorState::running;
  status_.valid = integrity_of(estimate).valid;
  status_.valid_estimates += status_.valid ? 1 : 0;
  std::visit([this](auto& e) { e.estimator = index_; }, estimate);
  if (const auto* attitude = std::get_if<AttitudeEstimate>(&estimate))
    listener.on_attitude(*attitude);
  else
    listener.on_navigation(std::get<NavigationEstimate>(estimate));
}

bool ExternalEstimator::is_in_time(const OutsideEstimate& estimate) const {
  const Stamp at = valid_at(estimate);
  return at >= oldest_allowed_ && (at <= newest_ || !peer_->account().in_steps);
}

std::string fault_of(const ExternalOptions& options) {
  return options.step > std::chrono::nanoseconds::zero() ? "" : "step_s is 0, allowed: above 0";
}

std::unique_ptr<Estimator> make_estimator(Seat seat, const ExternalOptions& options,
                                          const PipelineOptions&) {
  return std::make_unique<ExternalEstimator>(seat, options);
}

}  // namespace drydock::pipeline
