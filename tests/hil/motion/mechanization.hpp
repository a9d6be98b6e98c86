#pragma once

#include <Eigen/Geometry>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"

/// An independent check of inertial truth: it integrates specific force and angular rate back to
/// position, velocity and attitude.
namespace drydock::motion {

// A strapdown mechanization in ECEF. Its states and equations differ from those of the trajectory.
inline const Eigen::Vector3d earth_rate{0, 0, frame::wgs84::earth_rate_radps};

struct Mechanization {
  Eigen::Vector3d position, velocity;
  Eigen::Matrix3d body_to_ecef;
};

inline Mechanization derivative(const Mechanization& s, const Truth& imu) {
  const auto place = frame::geodetic(s.position);
  const Eigen::Matrix3d ned_to_ecef =
      frame::ecef_to_ned(place.latitude_rad, place.longitude_rad).transpose();
  const Eigen::Vector3d gravity =
      ned_to_ecef * Eigen::Vector3d{0, 0, frame::gravity(place.latitude_rad, place.height_m)};
  const Eigen::Vector3d rate = imu.angular_rate - s.body_to_ecef.transpose() * earth_rate;
  return {s.velocity,
          s.body_to_ecef * imu.specific_force + gravity - 2 * earth_rate.cross(s.velocity),
          s.body_to_ecef * frame::skew(rate)};
}

inline Mechanization plus(const Mechanization& s, double h, const Mechanization& d) {
  return {s.position + h * d.position, s.velocity + h * d.velocity,
          s.body_to_ecef + h * d.body_to_ecef};
}

inline Mechanization from_truth(const Truth& truth) {
  const Eigen::Matrix3d ned_to_ecef =
      frame::ecef_to_ned(truth.latitude_rad, truth.longitude_rad).transpose();
  return {frame::ecef({truth.latitude_rad, truth.longitude_rad, truth.height_m}),
          ned_to_ecef * truth.velocity_ned, ned_to_ecef * truth.body_to_ned.toRotationMatrix()};
}

/// The final difference between the integrated IMU of a trajectory (Runge-Kutta 4) and its truth.
struct MechanizationError {
  double position_m, velocity_mps, attitude_rad;
};

inline MechanizationError mechanize(const Trajectory& trajectory, Stamp from, double duration_s,
                                    double step_s) {
  const auto imu = [&](double t) { return trajectory.at(from + measurement::from_seconds(t)); };
  Truth begin = imu(0);
  Mechanization s = from_truth(begin);
  const auto steps = std::lround(duration_s / step_s);
  for (long i = 0; i < steps; ++i) {
    const double t = static_cast<double>(i) * step_s, h = step_s;
    const Truth middle = imu(t + h / 2), end = imu(static_cast<double>(i + 1) * step_s);
    const auto k1 = derivative(s, begin);
    const auto k2 = derivative(plus(s, h / 2, k1), middle);
    const auto k3 = derivative(plus(s, h / 2, k2), middle);
    const auto k4 = derivative(plus(s, h, k3), end);
    s = plus(plus(plus(plus(s, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
    begin = end;
  }
  const Mechanization truth = from_truth(begin);
  const Eigen::AngleAxisd turned(Eigen::Matrix3d(s.body_to_ecef.transpose() * truth.body_to_ecef));
  return {(s.position - truth.position).norm(), (s.velocity - truth.velocity).norm(),
          turned.angle()};
}

}  // namespace drydock::motion
