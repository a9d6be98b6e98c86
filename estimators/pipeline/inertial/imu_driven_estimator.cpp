#include "estimators/pipeline/inertial/imu_driven_estimator.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace drydock::pipeline {

using measurement::ImuSample;
using measurement::WaterSpeed;

namespace {

/// A filter whose innovations have contradicted for this long has diverged. If it does so again
/// within the second time, its sensors are in doubt more than before.
constexpr std::chrono::seconds diverged_after{2}, again_within{60};

/// A log that has contradicted for this long has changed and is believed.
constexpr std::chrono::seconds log_believed_after{60};

/// The doubt after a first divergence, how many times it grows each time, and how often. Chosen.
constexpr double doubted_rate = 1e-3, doubted_force = 0.05, doubted_speed = 0.25;
constexpr int rate_growth = 4, growth = 2, most_growths = 4;

/// `doubted`, grown so often.
double grown(double doubted, int by, int times) { return doubted * std::pow(by, times); }

/// After this many samples in a row from the past, the clock was set back. Fewer are late samples.
constexpr int set_back_after_samples = 10;

std::uint32_t bit(std::uint16_t device) { return std::uint32_t{1} << device; }

}  // namespace

ImuDrivenEstimator::ImuDrivenEstimator(Seat seat, std::optional<std::uint16_t> log,
                                       std::optional<GroundWitness> witness,
                                       const PipelineOptions& pipeline)
    : index_(seat.index),
      imu_(seat.imu),
      log_(log),
      witness_(std::move(witness)),
      max_imu_gap_(pipeline.max_imu_gap),
      max_speed_age_(pipeline.max_speed_age),
      gate_(pipeline.vehicle),
      alert_(pipeline.alert) {}

Outcome ImuDrivenEstimator::take(const ImuSample& sample, EstimateListener& listener) {
  if (sample.origin.device != imu_) return Outcome::unused;
  if (!sample.specific_force.allFinite() || !sample.angular_rate.allFinite())
    return Outcome::refused;
  if (last_ && sample.origin.valid_at <= last_->origin.valid_at) {
    if (!clock_was_set_back(sample)) return Outcome::late;
    stop();
  } else if (last_ && sample.origin.valid_at - last_->origin.valid_at > max_imu_gap_) {
    stop();
  }
  far_behind_ = 0;
  if (imu_doubted_) imu_trust_.judge(true, sample.origin.valid_at);
  const auto verdict = gate_.judge(sample);
  if (verdict == ImuGate::Verdict::wild) {
    ++status_.wild;
    return Outcome::refused;
  }
  if (verdict == ImuGate::Verdict::stepped) follow(gate_.step());
  note(sample);
  use(without_step(sample), listener);
  return Outcome::accepted;
}

void ImuDrivenEstimator::doubt(std::uint16_t device, bool doubted) {
  if (device != imu_) return;
  const bool over = imu_doubted_ && !doubted;
  imu_doubted_ = doubted;
  if (!over || !blind() || !running()) return;
  ++status_.restarts;
  start_over({});
  stopped_at_ = last_->origin.valid_at;
}

void ImuDrivenEstimator::use(const ImuSample& sample, EstimateListener& listener) {
  if (running()) {
    go_on(sample);
    judge(sample.origin.valid_at);
  }
  if (!running() && !try_start(sample)) status_.state = EstimatorState::waiting_for_speed;
  last_ = sample;
  if (running()) emit(listener);
}

ImuSample ImuDrivenEstimator::without_step(const ImuSample& sample) const {
  ImuSample without = sample;
  without.angular_rate -= rate_step_;
  without.specific_force -= force_step_;
  return without;
}

void ImuDrivenEstimator::follow(const ImuStep& step) {
  const Stamp now = last_ ? last_->origin.valid_at : Stamp{};
  ++status_.steps;
  imu_trust_.judge(true, now);
  // If the innovations contradicted before the step, the sensor was wrong then and is right now.
  if (step.thawed || motion_.contradicted(now, again_within)) return start_over({});
  rate_step_ += step.rate;
  force_step_ += step.force;
  if (!running()) return;
  loosen_biases(step.rate_sigma, step.force_sigma);
  if (step.turn_sigma > 0) bridge(BridgedGap::of_turn(step.turn_sigma));
  if (witness_) witness_->loosen_biases(step.rate_sigma, step.force_sigma);
}

void ImuDrivenEstimator::judge(Stamp now) {
  witness_trust_.judge((witness_ && witness_->contradicts()) || implausible(), now);
  motion_.judge(contradicted(), now);
  if (motion_.doubted(now) < diverged_after) return;
  ++status_.divergences;
  if (diverged_at_ && now - *diverged_at_ > again_within) diverged_in_a_row_ = 0;
  diverged_at_ = now;
  const int times = std::min(diverged_in_a_row_++, most_growths);
  const bool log = log_trust_.contradicted(now, again_within);
  start_over({grown(doubted_rate, rate_growth, times), grown(doubted_force, growth, times),
              log ? grown(doubted_speed, growth, times) : 0});
}

void ImuDrivenEstimator::start_over(const Doubt& doubt) {
  rate_step_ = force_step_ = Eigen::Vector3d::Zero();
  doubt_ = doubt;
  stopped_at_.reset();
  status_.state = EstimatorState::waiting_for_imu;
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

  const Correction correction = correct_with(*speed.longitudinal_mps);
  if (correction.innovation) tell(speed, *correction.innovation, listener);
  if (correction.used) {
    fed_by_ |= bit(*log_);
  } else {
    ++status_.rejected;
  }
  status_.last_speed = speed.origin.valid_at;
  return behind > behind.zero() ? Outcome::delayed : Outcome::accepted;
}

Outcome ImuDrivenEstimator::take(const measurement::BottomVelocity& track, EstimateListener&) {
  if (!witness_ || track.origin.device != witness_->device() || !track.velocity || !running())
    return Outcome::unused;
  // This comparison is false for NaN too.
  if (!(track.velocity->norm() <= max_speed_mps)) return Outcome::refused;
  const auto behind = last_->origin.valid_at - track.origin.valid_at;
  if (behind > max_speed_age_) return Outcome::late;
  if (behind < -max_speed_age_) return Outcome::unused;  // the IMU is silent
  witness_->compare(*track.velocity);
  return behind > behind.zero() ? Outcome::delayed : Outcome::accepted;
}

ImuDrivenEstimator::Correction ImuDrivenEstimator::correct_with(double speed_mps) {
  const Stamp now = last_->origin.valid_at;
  const Correction correction = correct(speed_mps, log_trust_.settled(now));
  log_trust_.judge(log_contradicted(), now);
  if (log_trust_.doubted(now) > log_believed_after) {
    believe_log(correction.innovation->value);
    log_trust_.forget();
  }
  return correction;
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
  gate_.forget();
}

bool ImuDrivenEstimator::try_start(const ImuSample& sample) {
  const bool fresh =
      speed_ && std::chrono::abs(sample.origin.valid_at - speed_->valid_at) <= max_speed_age_;
  if (log_ && !fresh) return false;
  const double speed_mps = log_ ? speed_->mps : 0.0;
  forget_innovations();
  motion_.end();
  if (stopped_at_) {
    // Negative after a clock was set back. Then the IMU was not silent.
    const double silent_s = measurement::seconds(sample.origin.valid_at - *stopped_at_);
    start_again(sample, speed_mps, std::max(silent_s, 0.0));
    if (witness_) witness_->start(sample, 0, 0);
  } else {
    start(sample, speed_mps);
    loosen_biases(doubt_.rate_radps, doubt_.force_mps2);
    believe_log(doubt_.speed_mps);
    if (witness_) witness_->start(sample, doubt_.rate_radps, doubt_.force_mps2);
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
  if (interval_s_ > 0 && dt > 1.5 * interval_s_) {
    const BridgedGap gap(dt);
    bridge(gap);
    if (witness_) witness_->loosen(gap.velocity_sigma_mps, gap.angle_sigma_rad);
  }
  interval_s_ = dt;
  const Eigen::Vector3d force = 0.5 * (last_->specific_force + sample.specific_force);
  const Eigen::Vector3d rate = 0.5 * (last_->angular_rate + sample.angular_rate);
  step(force, rate, dt);
  if (witness_) witness_->step(force, rate, dt);
}

Integrity ImuDrivenEstimator::integrity_of(const AttitudeEstimate& estimate) const {
  Integrity integrity;
  integrity.roll_bound_rad = bound_of(estimate.covariance(0, 0));
  integrity.pitch_bound_rad = bound_of(estimate.covariance(1, 1));
  // This comparison is false for NaN too.
  integrity.valid = integrity.roll_bound_rad <= alert_.attitude_rad &&
                    integrity.pitch_bound_rad <= alert_.attitude_rad;
  for (const Trust* trust : {&motion_, &log_trust_, &imu_trust_, &witness_trust_})
    integrity.valid &= trust->settled(estimate.valid_at);
  return integrity;
}

void ImuDrivenEstimator::emit(EstimateListener& listener) {
  ++status_.estimates;
  status_.last_estimate = last_->origin.valid_at;
  AttitudeEstimate estimate;
  estimate.valid_at = last_->origin.valid_at;
  estimate.estimator = index_;
  fill(estimate);
  estimate.integrity = integrity_of(estimate);
  status_.valid = estimate.integrity.valid;
  status_.valid_estimates += status_.valid ? 1 : 0;
  estimate.fed_by = fed_by_;
  listener.on_attitude(estimate);
}

}  // namespace drydock::pipeline
