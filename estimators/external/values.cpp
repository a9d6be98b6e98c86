#include "estimators/external/values.hpp"

#include <cmath>
#include <limits>

#include "estimators/frame/attitude.hpp"

namespace drydock::external {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Matrix3d or_nan(const std::optional<Matrix3d>& covariance) {
  return covariance.value_or(Matrix3d::Constant(nan));
}

double bound(double variance) {
  return std::isfinite(variance) ? pipeline::bound_of(variance) : infinite;
}

/// Rotation about N, E, D per change of roll, pitch and heading.
Matrix3d rotation_per_angles(double pitch, double heading) {
  const double cp = std::cos(pitch), sp = std::sin(pitch);
  const double ch = std::cos(heading), sh = std::sin(heading);
  Matrix3d j;
  j << ch * cp, -sh, 0, sh * cp, ch, 0, -sp, 0, 1;
  return j;
}

pipeline::AttitudeEstimate attitude_of(const Values& values) {
  const Vector3d angles = *values.roll_pitch_heading_rad;
  pipeline::AttitudeEstimate estimate;
  estimate.valid_at = values.valid_at;
  estimate.roll_rad = angles.x();
  estimate.pitch_rad = angles.y();
  if (std::isfinite(angles.z())) estimate.yaw_rad = angles.z();
  estimate.covariance = or_nan(values.attitude_rad2).topLeftCorner<2, 2>();
  estimate.integrity = {.valid = values.valid,
                        .roll_bound_rad = bound(estimate.covariance(0, 0)),
                        .pitch_bound_rad = bound(estimate.covariance(1, 1)),
                        .heading_bound_rad = {},
                        .horizontal_bound_m = {}};
  return estimate;
}

void set_attitude(const Values& values, pipeline::NavigationEstimate& estimate) {
  const Vector3d angles = values.roll_pitch_heading_rad.value_or(Vector3d::Constant(nan));
  estimate.body_to_ned = frame::body_to_ned({angles.x(), angles.y(), angles.z()});
  const Matrix3d j = rotation_per_angles(angles.y(), angles.z());
  estimate.covariance.bottomRightCorner<3, 3>() = j * or_nan(values.attitude_rad2) * j.transpose();
}

pipeline::NavigationEstimate navigation_of(const Values& values) {
  pipeline::NavigationEstimate estimate;
  estimate.valid_at = values.valid_at;
  estimate.position = values.position.value_or(frame::Position{nan, nan, nan});
  estimate.velocity_ned = values.velocity_ned_mps.value_or(Vector3d::Constant(nan));
  estimate.covariance.topLeftCorner<3, 3>() = or_nan(values.position_m2);
  estimate.covariance.block<3, 3>(3, 3) = or_nan(values.velocity_m2ps2);
  set_attitude(values, estimate);
  set_bounds(estimate);
  estimate.integrity.valid = values.valid;
  return estimate;
}

}  // namespace

pipeline::OutsideEstimate estimate_of(const Values& values, Gives gives) {
  if (gives == Gives::attitude) return attitude_of(values);
  return navigation_of(values);
}

void set_bounds(pipeline::NavigationEstimate& estimate) {
  const Matrix3d angles = pipeline::euler_covariance(estimate);
  auto& integrity = estimate.integrity;
  integrity.roll_bound_rad = bound(angles(0, 0));
  integrity.pitch_bound_rad = bound(angles(1, 1));
  if (std::isfinite(angles(2, 2))) integrity.heading_bound_rad = bound(angles(2, 2));
  const double horizontal = std::max(estimate.covariance(0, 0), estimate.covariance(1, 1));
  if (std::isfinite(horizontal)) integrity.horizontal_bound_m = bound(horizontal);
}

}  // namespace drydock::external
