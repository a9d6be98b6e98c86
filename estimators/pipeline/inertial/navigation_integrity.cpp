// What an inertial navigation promises, and when it knows that it has diverged.
#include <algorithm>
#include <array>
#include <cmath>

#include "estimators/pipeline/inertial/navigation_estimator.hpp"

namespace drydock::pipeline {

namespace {

/// A navigation that two of its sensors have contradicted for this long has diverged; of one alone
/// its gate knows what to do. Likewise a model.
constexpr std::chrono::seconds strayed_after{10};
/// A model that was contradicted so shortly before is less worth than the navigation. Chosen.
constexpr std::chrono::seconds model_believed_after{60};

/// A sensor that says nothing, because it is left out, says nothing against the model after this.
/// The estimate stays invalid until the sensor is back and agrees.
constexpr std::chrono::seconds sensor_forgotten_after{60};

/// It goes on from where it is, with these standard deviations. Chosen.
constexpr double anew_velocity_mps = 1, anew_angle_rad = 0.05;

}  // namespace

void NavigationEstimator::judge(double lasted_s) {
  const auto contradictions = watch_.contradictions();
  aiding_.judge(contradictions > 0, now_);
  // With a wrong IMU it would take the sensor's error for its own.
  state_.judge(imu_trust_.settled(now_) && filter_->diverged(watch_), now_);
  judge_model();
  strayed_m_ = aiding_.settled(now_) ? 0 : strayed_m_ + lasted_s * speed_off_mps();
  if (state_.doubted(now_) < strayed_after) return;
  if (model_.contradicted(now_, model_believed_after)) {
    filter_->restart_model();
  } else {
    ++status_.divergences;
    filter_->loosen(anew_velocity_mps, anew_angle_rad);
    filter_->loosen_position(std::hypot(watch_.off(Aid::position), strayed_m_));
  }
  watch_.clear();
  aiding_.end();
  state_.end();
}

// Log, DVL and depth say what the model is worth: the paper's filter compares them with it alone.
void NavigationEstimator::judge_model() {
  constexpr std::array sensors{Aid::log, Aid::ground, Aid::depth};
  const bool contradicted = std::ranges::any_of(sensors, [&](Aid sensor) {
    return watch_.contradicts(sensor, now_, sensor_forgotten_after);
  });
  model_.judge(options_.method == InertialMethod::paper && contradicted, now_);
  filter_->doubt_model(!model_.settled(now_));
  if (model_.doubted(now_) < strayed_after || !imu_trust_.settled(now_)) return;
  filter_->restart_model();
  model_.end();
}

double NavigationEstimator::speed_off_mps() const {
  if (options_.method == InertialMethod::paper) return watch_.off(Aid::model);
  return std::max(watch_.off(Aid::log), watch_.off(Aid::ground));
}

Integrity NavigationEstimator::integrity_of(const NavigationEstimate& estimate) const {
  const Eigen::Matrix3d angles = euler_covariance(estimate);
  const auto& p = estimate.covariance;
  Integrity integrity{
      .valid = aiding_.settled(now_) && imu_trust_.settled(now_) && vehicle_trust_.settled(now_),
      .roll_bound_rad = bound_of(angles(0, 0)),
      .pitch_bound_rad = bound_of(angles(1, 1)),
      .heading_bound_rad = bound_of(angles(2, 2)),
      .horizontal_bound_m = bound_of(p(0, 0) + p(1, 1))};
  // These comparisons are false for NaN too.
  integrity.valid &= integrity.roll_bound_rad <= alert_.attitude_rad &&
                     integrity.pitch_bound_rad <= alert_.attitude_rad &&
                     bound_of(p(3, 3) + p(4, 4)) <= alert_.velocity_mps;
  return integrity;
}

}  // namespace drydock::pipeline
