#include "estimators/pipeline/inertial/imu_driven_estimator.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace drydock::pipeline {

using measurement::ImuSample;
using measurement::WaterSpeed;

namespace {

/// After this many samples in a row from the past, the clock was set back. Fewer are late samples.
constexpr int set_back_after_samples = 10;

std::uint32_t bit(std::uint16_t device) { return std::uint32_t{1} << device; }

bool within(const Eigen::Vector3d& v, double limit) {
  return v.allFinite() && v.cwiseAbs().maxCoeff() <= limit;
}

}  // namespace

ImuDrivenEstimator::ImuDrivenEstimator(Seat seat, std::optional<std::uint16_t> log,
                                       const PipelineOptions& pipeline)
    : index_(seat.index),
      imu_(seat.imu),
      log_(log),
      max_imu_gap_(pipeline.max_imu_gap),
      max_speed_age_(pipeline.max_speed_age) {}

Outcome ImuDrivenEstimator::take(const ImuSample& sample, EstimateListener& listener) {
  if (sample.origin.device != imu_) return Outcome::unused;
  if (!within(sample.specific_force, max_specific_force_mps2) ||
      !within(sample.angular_rate, max_angular_rate_radps)) {
    return Outcome::refused;
  }
  if (last_ && sample.origin.valid_at <= last_->origin.valid_at) {
    if (!clock_was_set_back(sample)) return Outcome::late;
    stop();
  } else if (last_ && sample.origin.valid_at - last_->origin.valid_at > max_imu_gap_) {
    stop();
  }
  far_behind_ = 0;
  if (running()) {
    go_on(sample);
  } else if (!try_start(sample)) {
    status_.state = EstimatorState::waiting_for_speed;
  }
  last_ = sample;
  if (running()) emit(listener);
  return Outcome::accepted;
}

Outcome ImuDrivenEstimator::take(const WaterSpeed& speed, EstimateListener& listener) {
  if (!log_ || speed.origin.device != log_ || !speed.longitudinal_mps) return Outcome::unused;
  // This comparison is false for NaN too.
  if (!(std::abs(*speed.longitudinal_mps) <= max_speed_mps)) return Outcome::refused;

  speed_ = Speed{speed.origin.valid_at, *speed.longitudinal_mps};
  if (!running()) return Outcome::accepted;
  const auto behind = last_->origin.valid_at - speed.origin.valid_at;
  if (behind > max_speed_age_) return Outcome::late;
  if (behind < -max_speed_age_) return Outcome::unused;  // the IMU is silent; speed_ keeps it

  const Correction correction = correct(*speed.longitudinal_mps);
  if (correction.innovation) tell(speed, *correction.innovation, listener);
  if (correction.used) {
    fed_by_ |= bit(*log_);
  } else {
    ++status_.rejected;
  }
  status_.last_speed = speed.origin.valid_at;
  return behind > behind.zero() ? Outcome::delayed : Outcome::accepted;
}

void ImuDrivenEstimator::tell(const WaterSpeed& speed, const navigation::Innovation& innovation,
                              EstimateListener& listener) {
  if (innovation.used) status_.taken.add(innovation.normalised_square());
  listener.on_innovation({speed.origin.valid_at, index_, speed.origin.device, {1, innovation}});
}

bool ImuDrivenEstimator::clock_was_set_back(const ImuSample& sample) {
  const bool far = last_->origin.valid_at - sample.origin.valid_at > max_imu_gap_;
  far_behind_ = far ? far_behind_ + 1 : 0;
  return far_behind_ >= set_back_after_samples;
}

void ImuDrivenEstimator::stop() {
  if (running()) {
    ++status_.restarts;
    stopped_at_ = last_->origin.valid_at;
  }
  status_.state = EstimatorState::waiting_for_imu;
  last_.reset();
}

bool ImuDrivenEstimator::try_start(const ImuSample& sample) {
  const bool fresh =
      speed_ && std::chrono::abs(sample.origin.valid_at - speed_->valid_at) <= max_speed_age_;
  if (log_ && !fresh) return false;
  const double speed_mps = log_ ? speed_->mps : 0.0;
  if (stopped_at_) {
    // Negative after a clock was set back. Then the IMU was not silent.
    const double silent_s = measurement::seconds(sample.origin.valid_at - *stopped_at_);
    start_again(sample, speed_mps, std::max(silent_s, 0.0));
  } else {
    start(sample, speed_mps);
  }
  interval_s_ = 0;
  status_.state = EstimatorState::running;
  fed_by_ = bit(imu_) | (log_ ? bit(*log_) : 0);
  if (log_) status_.last_speed = speed_->valid_at;
  return true;
}

void ImuDrivenEstimator::go_on(const ImuSample& sample) {
  // A sample is valid at an instant. The mean of two samples is right for the interval between them
  // to the second order.
  const double dt = measurement::seconds(sample.origin.valid_at - last_->origin.valid_at);
  if (interval_s_ > 0 && dt > 1.5 * interval_s_) bridge(BridgedGap(dt));
  interval_s_ = dt;
  step(0.5 * (last_->specific_force + sample.specific_force),
       0.5 * (last_->angular_rate + sample.angular_rate), dt);
}

void ImuDrivenEstimator::emit(EstimateListener& listener) {
  ++status_.estimates;
  status_.last_estimate = last_->origin.valid_at;
  AttitudeEstimate estimate;
  estimate.valid_at = last_->origin.valid_at;
  estimate.estimator = index_;
  fill(estimate);
  estimate.fed_by = fed_by_;
  listener.on_attitude(estimate);
}

}  // namespace drydock::pipeline
