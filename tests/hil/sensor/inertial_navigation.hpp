#pragma once

#include <Eigen/Geometry>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"
#include "hil/sensor/increments.hpp"

/// A strapdown mechanization in ECEF that uses only an IMU's increments and, for its height, the
/// true height. Its states and equations differ from those of the trajectory.
namespace drydock::sensor::test {

using Eigen::Matrix3d;
using Eigen::Vector3d;

inline Matrix3d turn(const Vector3d& rotation) {
  const double angle = rotation.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix()
                   : Matrix3d::Identity().eval();
}

class InertialNavigation {
 public:
  explicit InertialNavigation(const motion::Truth& truth) { set(truth); }

  /// Advances by two intervals of dt seconds each (coning and sculling for rates linear in time:
  /// Savage, "Strapdown Inertial Navigation Integration Algorithm Design", J. Guidance 21(1-2),
  /// 1998).
  void advance(const Increments& a, const Increments& b, double dt) {
    const double h = 2 * dt;
    const Vector3d angle = a.angle + b.angle, sum = a.velocity + b.velocity;
    const Vector3d coned = angle + 2.0 / 3 * a.angle.cross(b.angle);
    const Vector3d sculled = sum + angle.cross(sum) / 2 + angle.cross(angle.cross(sum)) / 6 +
                             2.0 / 3 * (a.angle.cross(b.velocity) + a.velocity.cross(b.angle));
    const Vector3d earth{0, 0, frame::wgs84::earth_rate_radps};

    const Vector3d middle = position + h / 2 * velocity;
    const auto place = frame::geodetic(middle);
    const Matrix3d to_ecef =
        frame::ecef_to_ned(place.latitude_rad, place.longitude_rad).transpose();
    const Vector3d gravity = to_ecef.col(2) * frame::gravity(place.latitude_rad, place.height_m);
    const Vector3d from_force = turn(-h / 2 * earth) * body_to_ecef * sculled;
    const Vector3d half_way = velocity + (from_force + h * gravity) / 2;
    const Vector3d after = velocity + from_force + h * (gravity - 2 * earth.cross(half_way));
    position += h / 2 * (velocity + after);
    velocity = after;
    body_to_ecef = turn(-h * earth) * body_to_ecef * turn(coned);
  }

  /// Second-order loop on the true height. Without it height errors grow by a factor e in ten
  /// minutes, and 1e14 in 5.5 h. Returns the correction of the vertical acceleration, m/s2.
  double hold_height(double height_m, double dt) {
    constexpr double time_s = 30, stiffness = 1 / (time_s * time_s), damping = 2 / time_s;
    const auto place = frame::geodetic(position);
    const Vector3d up =
        -frame::ecef_to_ned(place.latitude_rad, place.longitude_rad).row(2).transpose();
    const double error = height_m - place.height_m;
    position += dt * damping * error * up;
    velocity += dt * stiffness * error * up;
    return stiffness * error;
  }

  struct Error {
    double position_m, velocity_mps, attitude_rad;
  };
  Error against(const motion::Truth& truth) const {
    InertialNavigation right = *this;
    right.set(truth);
    const Eigen::AngleAxisd turned(Matrix3d(body_to_ecef.transpose() * right.body_to_ecef));
    return {(position - right.position).norm(), (velocity - right.velocity).norm(), turned.angle()};
  }

  Vector3d position, velocity;
  Matrix3d body_to_ecef;

 private:
  void set(const motion::Truth& truth) {
    const Matrix3d to_ecef =
        frame::ecef_to_ned(truth.latitude_rad, truth.longitude_rad).transpose();
    position = frame::ecef({truth.latitude_rad, truth.longitude_rad, truth.height_m});
    velocity = to_ecef * truth.velocity_ned;
    body_to_ecef = to_ecef * truth.body_to_ned.toRotationMatrix();
  }
};

}  // namespace drydock::sensor::test
