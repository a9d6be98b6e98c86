#include <algorithm>
#include <cmath>

#include "estimators/pipeline/reckoning/dead_reckoning_estimator.hpp"

/// What dead reckoning tells of its track.
namespace drydock::pipeline {

using Eigen::Vector2d;

NavigationEstimate DeadReckoningEstimator::estimate() const {
  NavigationEstimate estimate;
  estimate.valid_at = last_->valid_at;
  estimate.estimator = index_;
  estimate.position = frame::at_ned_offset(*position_, -arm(place()));
  const Vector2d measured = last_->ned.head<2>();
  const Vector2d ground = filter_.over_ground(measured, last_->over);
  const Eigen::Vector3d turning = Eigen::Vector3d(0, 0, angles_.turn_radps()).cross(arm(place()));
  estimate.velocity_ned = Eigen::Vector3d(ground.x(), ground.y(), last_->ned.z()) - turning;
  frame::Euler corrected = attitude_;
  corrected.yaw = frame::wrap_pi(attitude_.yaw + filter_.heading_error());
  estimate.body_to_ned = frame::body_to_ned(corrected);
  const auto& covariance = filter_.covariance();
  const double tilt =
      std::max(angles_.roll_variance(last_->valid_at), angles_.pitch_variance(last_->valid_at));
  const double speed_noise = options_.errors.velocity_mps * options_.errors.velocity_mps;
  const WayNoise noise = noise_of(*last_, 0);
  auto& p = estimate.covariance;
  p.topLeftCorner<2, 2>() = covariance.topLeftCorner<2, 2>();
  p.diagonal().head<2>().array() += separation_variance(last_->valid_at);
  p(2, 2) = down_variance_;
  p.block<2, 2>(3, 3) = filter_.velocity_covariance(measured, last_->over);
  p.diagonal().segment<2>(3).array() +=
      noise.aside_mps * noise.aside_mps + noise.wrong_mps * noise.wrong_mps;
  p(5, 5) = speed_noise + tilt * ground.squaredNorm();
  p(6, 6) = p(7, 7) = tilt;
  p(8, 8) = covariance(2, 2) + std::pow(unseen_heading_rad(last_->valid_at), 2);
  if (options_.log) {
    estimate.current = CurrentEstimate{filter_.current(), filter_.current_sigma()};
  }
  estimate.fed_by = fed_by_;
  estimate.integrity = integrity_of(estimate);
  return estimate;
}

Integrity DeadReckoningEstimator::integrity_of(const NavigationEstimate& estimate) const {
  const auto& p = estimate.covariance;
  Integrity integrity;
  integrity.roll_bound_rad = integrity.pitch_bound_rad = bound_of(p(6, 6));
  integrity.heading_bound_rad = bound_of(p(8, 8));
  integrity.horizontal_bound_m = bound_of(std::max(p(0, 0), p(1, 1)));
  // These comparisons are false for NaN too.
  integrity.valid = *integrity.heading_bound_rad <= alert_.attitude_rad &&
                    integrity.roll_bound_rad <= alert_.attitude_rad &&
                    bound_of(std::max(p(3, 3), p(4, 4))) <= alert_.velocity_mps &&
                    fixes_.agrees(estimate.valid_at) && speeds_.agrees(estimate.valid_at) &&
                    angles_.agrees(estimate.valid_at);
  return integrity;
}

void DeadReckoningEstimator::emit(EstimateListener& listener) {
  const NavigationEstimate told = estimate();
  ++status_.estimates;
  status_.last_estimate = told.valid_at;
  status_.valid = told.integrity.valid;
  status_.valid_estimates += status_.valid ? 1 : 0;
  listener.on_navigation(told);
}

}  // namespace drydock::pipeline
