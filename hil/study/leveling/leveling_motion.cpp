#include "hil/study/leveling/leveling_motion.hpp"

#include <cmath>

#include "estimators/frame/earth.hpp"

namespace drydock::study {

using Eigen::Vector3d;

namespace {

/// a sin(w t) and its first two derivatives.
struct Swing {
  double value, rate, acceleration;
};

Swing swing(double amplitude, double period, double t) {
  const double w = 2 * std::numbers::pi / period;
  const double sine = amplitude * std::sin(w * t), cosine = amplitude * std::cos(w * t);
  return {sine, w * cosine, -w * w * sine};
}

}  // namespace

frame::Euler LevelingMotion::attitude(double t) const {
  return {swing(roll, roll_period, t).value, swing(pitch, pitch_period, t).value,
          swing(yaw, yaw_period, t).value};
}

Vector3d LevelingMotion::euler_rates(double t) const {
  return {swing(roll, roll_period, t).rate, swing(pitch, pitch_period, t).rate,
          swing(yaw, yaw_period, t).rate};
}

Vector3d LevelingMotion::velocity(double t) const {
  return {speed_mps + swing(surge_mps, yaw_period, t).value,
          -slip_m * swing(yaw, yaw_period, t).rate, 0};
}

Vector3d LevelingMotion::acceleration(double t) const {
  return {swing(surge_mps, yaw_period, t).rate, -slip_m * swing(yaw, yaw_period, t).acceleration,
          0};
}

LevelingReading LevelingMotion::reading(double t, double dt, double latitude_rad) const {
  const double middle = t + dt / 2;
  const auto euler = attitude(middle);
  const Eigen::Matrix3d to_body = frame::ned_to_body(euler);
  const Vector3d earth = to_body * frame::earth_rate_ned(latitude_rad);
  const Vector3d rate = frame::body_rate(euler, euler_rates(middle)) + earth;
  const Vector3d gravity = to_body * Vector3d{0, 0, frame::gravity(latitude_rad)};
  return {acceleration(middle) + (rate + earth).cross(velocity(middle)) - gravity, rate,
          velocity(t + dt).x()};
}

}  // namespace drydock::study
