#include "estimators/pipeline/leveling_estimator.hpp"

#include <Eigen/Core>
#include <cmath>
#include <variant>

namespace drydock::pipeline {

using measurement::ImuSample;
using measurement::WaterSpeed;

namespace {

/// As many samples in a row from the past are no stragglers: the clock was set back.
constexpr int set_back_after_samples = 10;

std::uint32_t bit(std::uint16_t device) { return std::uint32_t{1} << device; }

bool within(const Eigen::Vector3d& v, double limit) {
  return v.allFinite() && v.cwiseAbs().maxCoeff() <= limit;
}

}  // namespace

LevelingEstimator::LevelingEstimator(std::uint16_t index, const EstimatorOptions& options,
                                     const PipelineOptions& pipeline)
    : index_(index),
      imu_(options.imu),
      log_(options.log),
      stationary_(options.stationary),
      max_imu_gap_(pipeline.max_imu_gap),
      max_speed_age_(pipeline.max_speed_age),
      filter_(leveling::make_filter(options.filter, options.leveling)) {}

Outcome LevelingEstimator::take(const ImuSample& sample, EstimateListener& listener) {
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
    step(sample);
  } else if (!try_start(sample)) {
    status_.state = EstimatorState::waiting_for_speed;
  }
  last_ = sample;
  if (running()) emit(listener);
  return Outcome::accepted;
}

Outcome LevelingEstimator::take(const WaterSpeed& speed, EstimateListener&) {
  if (stationary_ || speed.origin.device != log_ || !speed.longitudinal_mps) {
    return Outcome::unused;
  }
  // A comparison that NaN fails as well.
  if (!(std::abs(*speed.longitudinal_mps) <= max_speed_mps)) return Outcome::refused;

  speed_ = Speed{speed.origin.valid_at, *speed.longitudinal_mps};
  if (!running()) return Outcome::accepted;
  const auto behind = last_->origin.valid_at - speed.origin.valid_at;
  if (behind > max_speed_age_) return Outcome::late;
  if (behind < -max_speed_age_) return Outcome::unused;  // the IMU is silent: kept for its return

  std::visit([&](auto& filter) { filter.update_moving(*speed.longitudinal_mps); }, filter_);
  fed_by_ |= bit(*log_);
  status_.last_speed = speed.origin.valid_at;
  return behind > behind.zero() ? Outcome::delayed : Outcome::accepted;
}

bool LevelingEstimator::clock_was_set_back(const ImuSample& sample) {
  const bool far = last_->origin.valid_at - sample.origin.valid_at > max_imu_gap_;
  far_behind_ = far ? far_behind_ + 1 : 0;
  return far_behind_ >= set_back_after_samples;
}

void LevelingEstimator::stop() {
  if (running()) ++status_.restarts;
  status_.state = EstimatorState::waiting_for_imu;
  last_.reset();
}

bool LevelingEstimator::try_start(const ImuSample& sample) {
  const bool fresh =
      speed_ && std::chrono::abs(sample.origin.valid_at - speed_->valid_at) <= max_speed_age_;
  if (!stationary_ && !fresh) return false;
  const double speed = stationary_ ? 0.0 : speed_->mps;
  std::visit([&](auto& filter) { filter.start(sample.specific_force, sample.angular_rate, speed); },
             filter_);
  status_.state = EstimatorState::running;
  fed_by_ = bit(imu_) | (stationary_ ? 0 : bit(*log_));
  if (!stationary_) status_.last_speed = speed_->valid_at;
  return true;
}

void LevelingEstimator::step(const ImuSample& sample) {
  // Samples are instants: their mean stands for the interval between them to the second order.
  const double dt = measurement::seconds(sample.origin.valid_at - last_->origin.valid_at);
  const Eigen::Vector3d force = 0.5 * (last_->specific_force + sample.specific_force);
  const Eigen::Vector3d rate = 0.5 * (last_->angular_rate + sample.angular_rate);
  std::visit(
      [&](auto& filter) {
        filter.predict(force, rate, dt);
        if (stationary_) {
          filter.update_stationary();
        } else {
          filter.update_nonholonomic(dt);
        }
      },
      filter_);
}

void LevelingEstimator::emit(EstimateListener& listener) {
  ++status_.estimates;
  status_.last_estimate = last_->origin.valid_at;
  AttitudeEstimate estimate;
  estimate.valid_at = last_->origin.valid_at;
  estimate.estimator = index_;
  std::visit(
      [&](const auto& filter) {
        estimate.roll_rad = filter.roll();
        estimate.pitch_rad = filter.pitch();
        estimate.covariance = filter.roll_pitch_covariance();
      },
      filter_);
  estimate.fed_by = fed_by_;
  listener.on_attitude(estimate);
}

}  // namespace drydock::pipeline
