// What an inertial navigation does with samples of its IMU that are not as its data sheet says.
#include <chrono>
#include <cmath>

#include "estimators/pipeline/inertial/navigation_estimator.hpp"

namespace drydock::pipeline {

using Eigen::Vector3d;
using measurement::ImuSample;

namespace {

/// A step of an IMU that was contradicted so shortly before it is the end of a fault.
constexpr std::chrono::seconds wrong_within{60};

}  // namespace

bool NavigationEstimator::passes_gate(const ImuSample& sample) {
  if (imu_doubted_) imu_trust_.judge(true, sample.origin.valid_at);
  const auto verdict = gate_.judge(sample);
  if (verdict == ImuGate::Verdict::wild) {
    ++status_.wild;
    return false;
  }
  if (verdict == ImuGate::Verdict::good) return true;
  const ImuStep& step = gate_.step();
  ++status_.steps;
  imu_trust_.judge(true, sample.origin.valid_at);
  if (step.thawed || was_wrong(sample.origin.valid_at)) {
    rate_step_ = force_step_ = Vector3d::Zero();
  } else {
    rate_step_ += step.rate;
    force_step_ += step.force;
  }
  filter_->loosen_biases(step.rate_sigma, step.force_sigma);
  filter_->loosen(0, step.turn_sigma);
  return true;
}

bool NavigationEstimator::was_wrong(measurement::Stamp now) const {
  return aiding_.contradicted(now, wrong_within) || vehicle_trust_.contradicted(now, wrong_within);
}

ImuSample NavigationEstimator::without_step(const ImuSample& sample) const {
  ImuSample without = sample;
  without.angular_rate -= rate_step_;
  without.specific_force -= force_step_;
  return without;
}

// Noise beyond that of the filter's options, which its covariance does not contain.
void NavigationEstimator::widen_by_noise(double dt) {
  const auto& sheet = options_.navigation;
  const double period = options_.imu_period_s;
  const double angle =
      beyond_sheet(noise_.rate_variance() * period, std::pow(sheet.angle_noise_rad, 2));
  const double velocity =
      beyond_sheet(noise_.force_variance() * period, std::pow(sheet.velocity_noise_mps, 2));
  if (angle > 0 || velocity > 0) filter_->loosen(std::sqrt(velocity * dt), std::sqrt(angle * dt));
}

}  // namespace drydock::pipeline
