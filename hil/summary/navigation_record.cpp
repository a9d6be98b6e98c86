#include "hil/summary/navigation_record.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"

namespace drydock::summary {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

frame::Position true_position(const motion::Truth& truth) {
  return {truth.latitude_rad, truth.longitude_rad, truth.height_m};
}

frame::Position position_of(const bus::Navigation& estimate) {
  return {estimate.latitude_rad, estimate.longitude_rad, estimate.height_m};
}

double sigma_of(const bus::Navigation& estimate, Eigen::Index i) {
  return std::sqrt(std::max(0.0, estimate.covariance(i, i)));
}

}  // namespace

void NavigationRecord::note(const bus::Navigation& estimate,
                            const std::optional<host::Current>& current, const motion::Truth* truth,
                            double t_s, bool draw) {
  if (!origin_) origin_ = truth ? true_position(*truth) : position_of(estimate);
  if (draw) {
    const Vector3d at = frame::ned_offset(*origin_, position_of(estimate));
    trace_.t_s.push_back(t_s);
    trace_.north_m.push_back(at.x());
    trace_.east_m.push_back(at.y());
    trace_.north_sigma_m.push_back(sigma_of(estimate, 0));
    trace_.east_sigma_m.push_back(sigma_of(estimate, 1));
    for (std::size_t i = 0; i < 3; ++i)
      trace_.velocity_sigma_mps[i].push_back(sigma_of(estimate, 3 + static_cast<int>(i)));
    if (current) {
      trace_.current_north_mps.push_back(current->north_east_mps.x());
      trace_.current_east_mps.push_back(current->north_east_mps.y());
    }
  }
  if (truth) compare(estimate, *truth, draw);
}

void NavigationRecord::compare(const bus::Navigation& estimate, const motion::Truth& truth,
                               bool draw) {
  const Vector3d off = frame::ned_offset(true_position(truth), position_of(estimate));
  const Vector3d velocity = estimate.velocity_ned - truth.velocity_ned;
  const frame::Euler angles = frame::euler(estimate.body_to_ned);
  const Vector3d turned{frame::wrap_pi(angles.roll - truth.roll_rad),
                        frame::wrap_pi(angles.pitch - truth.pitch_rad),
                        frame::wrap_pi(angles.yaw - truth.yaw_rad)};
  const Vector2d horizontal = off.head<2>();
  ++count_;
  horizontal_last_ = horizontal.norm();
  horizontal_.add_square(horizontal.squaredNorm(), horizontal_last_);
  down_.add(off.z());
  speed_.add_square(velocity.squaredNorm(), velocity.norm());
  roll_.add(turned.x());
  pitch_.add(turned.y());
  heading_.add(turned.z());
  const Eigen::Matrix2d covariance = estimate.covariance.topLeftCorner<2, 2>();
  const double normalised = horizontal.dot(covariance.inverse() * horizontal) / 2;
  nees_.add_square(normalised, normalised);
  if (!draw) return;
  const Vector3d at = frame::ned_offset(*origin_, true_position(truth));
  trace_.true_north_m.push_back(at.x());
  trace_.true_east_m.push_back(at.y());
  trace_.north_error_m.push_back(off.x());
  trace_.east_error_m.push_back(off.y());
  for (std::size_t i = 0; i < 3; ++i)
    trace_.velocity_error_mps[i].push_back(velocity(static_cast<int>(i)));
}

std::optional<NavigationError> NavigationRecord::error() const {
  if (count_ == 0) return {};
  const auto degrees = [](const ErrorSum& angle) {
    return angle.rms() * units::degrees_per_radian;
  };
  return NavigationError{.horizontal_rms_m = horizontal_.rms(),
                         .horizontal_max_m = horizontal_.largest(),
                         .horizontal_end_m = horizontal_last_,
                         .depth_rms_m = down_.rms(),
                         .velocity_rms_mps = speed_.rms(),
                         .velocity_max_mps = speed_.largest(),
                         .roll_rms_deg = degrees(roll_),
                         .pitch_rms_deg = degrees(pitch_),
                         .heading_rms_deg = degrees(heading_),
                         .nees_position = nees_.mean()};
}

}  // namespace drydock::summary
