#pragma once

#include <Eigen/Geometry>

namespace drydock::device {

/// Orientation of a sensor in the vehicle: body axes rotated by yaw, then pitch, then roll are the
/// sensor's axes. This is the only place where vectors of a sensor become vectors of the body
/// (FRD), and back. It does not apply the lever arm: the correction w x r needs the angular rate,
/// which the estimator has.
class Mounting {
 public:
  Mounting() = default;
  Mounting(double roll_rad, double pitch_rad, double yaw_rad)
      : sensor_to_body_((Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
                         Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
                         Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()))
                            .toRotationMatrix()) {}

  Eigen::Vector3d to_body(const Eigen::Vector3d& in_sensor_axes) const {
    return sensor_to_body_ * in_sensor_axes;
  }

  Eigen::Vector3d to_sensor(const Eigen::Vector3d& in_body) const {
    return sensor_to_body_.transpose() * in_body;
  }

  Eigen::Matrix3d covariance_to_body(const Eigen::Matrix3d& in_sensor_axes) const {
    return sensor_to_body_ * in_sensor_axes * sensor_to_body_.transpose();
  }

  bool is_identity() const { return sensor_to_body_.isIdentity(0); }

 private:
  Eigen::Matrix3d sensor_to_body_ = Eigen::Matrix3d::Identity();
};

}  // namespace drydock::device
