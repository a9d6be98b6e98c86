#include "estimators/leveling/level_kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"

namespace drydock::leveling {

using Eigen::Vector3d;
using frame::skew;

namespace {

/// Below this cosine of pitch, roll and heading are not defined and keep their values.
constexpr double vertical = 1e-6;

}  // namespace

Vector3d alpha_of(double roll, double pitch) {
  return {-std::sin(pitch), std::sin(roll) * std::cos(pitch), std::cos(roll) * std::cos(pitch)};
}

double roll_of(const Vector3d& alpha) { return std::atan2(alpha.y(), alpha.z()); }

double pitch_of(const Vector3d& alpha) {
  return std::atan2(-alpha.x(), std::hypot(alpha.y(), alpha.z()));
}

Eigen::Matrix2d roll_pitch_covariance(const Vector3d& alpha, const Eigen::Matrix3d& covariance) {
  const double across = std::max(std::hypot(alpha.y(), alpha.z()), vertical);
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << 0, alpha.z() / (across * across), -alpha.y() / (across * across),  //
      -across, alpha.x() * alpha.y() / across, alpha.x() * alpha.z() / across;
  jacobian.row(1) /= alpha.squaredNorm();
  return jacobian * covariance * jacobian.transpose();
}

FirstAlpha first_alpha(const LevelingOptions& options, const Vector3d& specific_force,
                       const Vector3d& angular_rate, double speed_mps, double gravity_mps2,
                       double sigma) {
  // Eq. (15) solved for g alpha with V steady: what the accelerometers feel besides gravity is the
  // turn.
  const Vector3d down = angular_rate.cross(Vector3d{speed_mps, 0, 0}) - specific_force;
  if (options.accelerometer_start && down.norm() > 0.1 * gravity_mps2)
    return {down.normalized(), sigma};
  return {alpha_of(options.initial_roll_rad, options.initial_pitch_rad),
          options.initial_alpha_sigma};
}

Matrix6 system_matrix(const Vector3d& rate_nb, const Vector3d& rate_coriolis, double gravity_mps2) {
  Matrix6 f = Matrix6::Zero();
  f.topLeftCorner<3, 3>() = -skew(rate_coriolis);
  f.topRightCorner<3, 3>().diagonal().setConstant(gravity_mps2);
  f.bottomRightCorner<3, 3>() = -skew(rate_nb);
  return f;
}

Transition::Transition(const Matrix6& f, double dt) {
  const Matrix6 a = f * dt, identity = Matrix6::Identity();
  mean = identity + a * (identity / 2 + a / 6);
  step = identity + a * mean;
}

double carried_heading(double heading, const Vector3d& alpha, const Vector3d& rate_nb, double dt) {
  // The rate is (q sin(roll) + r cos(roll)) / cos(pitch), written with alpha.
  const Vector3d unit = alpha.normalized();
  const double across_squared = unit.y() * unit.y() + unit.z() * unit.z();
  if (across_squared < vertical) return heading;
  const double rate = (rate_nb.y() * unit.y() + rate_nb.z() * unit.z()) / across_squared;
  return frame::wrap_pi(heading + rate * dt);
}

double turn_noise(const LevelingOptions& options, const Vector3d& rate) {
  // The error of the rate is fixed to the body while it turns by a radian, in 1/rate.
  return 2 * options.rate_share * options.rate_share * rate.norm();
}

Nonholonomic::Nonholonomic(const LevelingOptions& options, double turn, double dt) {
  const auto squared = [](double x) { return x * x; };
  if (const auto& density = options.transverse_speed_density)
    transverse = (squared(*density) + squared(options.slip_density * turn)) / dt;
  if (const auto& density = options.vertical_speed_density) vertical = squared(*density) / dt;
}

}  // namespace drydock::leveling
