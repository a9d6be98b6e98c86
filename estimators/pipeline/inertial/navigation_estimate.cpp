#include "estimators/pipeline/inertial/navigation_estimate.hpp"

#include <Eigen/LU>

#include "estimators/frame/attitude.hpp"

namespace drydock::pipeline {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d euler_covariance(const NavigationEstimate& estimate) {
  const double yaw = frame::euler(estimate.body_to_ned).yaw;
  // The axes of roll, pitch and yaw, in NED. Small angles about them add up to a rotation vector.
  Matrix3d axes;
  axes << estimate.body_to_ned * Vector3d::UnitX(),
      AngleAxisd{yaw, Vector3d::UnitZ()} * Vector3d::UnitY(), Vector3d::UnitZ();
  const Matrix3d by_rotation = axes.inverse();
  return by_rotation * estimate.covariance.bottomRightCorner<3, 3>() * by_rotation.transpose();
}

AttitudeEstimate attitude_of(const NavigationEstimate& estimate) {
  const frame::Euler angles = frame::euler(estimate.body_to_ned);
  AttitudeEstimate attitude;
  attitude.valid_at = estimate.valid_at;
  attitude.estimator = estimate.estimator;
  attitude.roll_rad = angles.roll;
  attitude.pitch_rad = angles.pitch;
  attitude.yaw_rad = angles.yaw;
  attitude.covariance = euler_covariance(estimate).topLeftCorner<2, 2>();
  attitude.fed_by = estimate.fed_by;
  attitude.integrity = estimate.integrity;
  return attitude;
}

}  // namespace drydock::pipeline
