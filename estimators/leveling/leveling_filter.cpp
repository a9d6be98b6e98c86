#include "estimators/leveling/leveling_filter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"

namespace drydock::leveling {

using Eigen::Vector3d;
using frame::skew;

namespace {

using State = LevelingFilter::State;
using Matrix6 = LevelingFilter::Covariance;

/// Eq. (5).
Vector3d alpha_of(double roll, double pitch) {
  return {-std::sin(pitch), std::sin(roll) * std::cos(pitch), std::cos(roll) * std::cos(pitch)};
}

/// Below this cosine of pitch, roll and heading are not defined and are left as they were.
constexpr double vertical = 1e-6;

}  // namespace

LevelingFilter::LevelingFilter(const LevelingOptions& options)
    : options_(options),
      gravity_(frame::gravity(options.latitude_rad, options.height_m)),
      earth_rate_ned_(frame::earth_rate_ned(options.latitude_rad)),
      heading_(frame::wrap_pi(options.heading_rad)) {}

void LevelingFilter::start(const Vector3d& specific_force, const Vector3d& angular_rate,
                           double speed_mps) {
  const Vector3d velocity{speed_mps, 0, 0};
  // Eq. (15) solved for g alpha with V steady: what the accelerometers feel besides gravity is the
  // turn. A specific force of nearly nothing (free fall) tells no direction.
  const Vector3d down = angular_rate.cross(velocity) - specific_force;
  const bool by_accelerometer = options_.accelerometer_start && down.norm() > 0.1 * gravity_;
  x_ << velocity, by_accelerometer
                      ? Vector3d{down.normalized()}
                      : alpha_of(options_.initial_roll_rad, options_.initial_pitch_rad);
  const double alpha_sigma =
      by_accelerometer ? options_.accelerometer_start_alpha_sigma : options_.initial_alpha_sigma;
  p_.setZero();
  p_.diagonal().head<3>().setConstant(std::pow(options_.initial_velocity_sigma_mps, 2));
  p_.diagonal().tail<3>().setConstant(alpha_sigma * alpha_sigma);
  innovation_ = {};
}

Matrix6 LevelingFilter::system_matrix(const Vector3d& rate_nb, const Vector3d& rate_coriolis,
                                      double gravity_mps2) {
  Matrix6 f = Matrix6::Zero();
  f.topLeftCorner<3, 3>() = -skew(rate_coriolis);
  f.topRightCorner<3, 3>().diagonal().setConstant(gravity_mps2);
  f.bottomRightCorner<3, 3>() = -skew(rate_nb);
  return f;
}

void LevelingFilter::predict(const Vector3d& specific_force, const Vector3d& angular_rate,
                             double dt) {
  const Vector3d earth_rate = earth_rate_body();             // eq. (16)
  const Vector3d rate_nb = angular_rate - earth_rate;        // eq. (17)
  const Vector3d rate_coriolis = angular_rate + earth_rate;  // eq. (15)

  // With F constant over dt: x <- e^A x + dt (I + A/2 + A^2/6) b, A = F dt, to the third order.
  const Matrix6 a = system_matrix(rate_nb, rate_coriolis, gravity_) * dt;
  const Matrix6 identity = Matrix6::Identity();
  const Matrix6 mean = identity + a * (identity / 2 + a / 6);
  const Matrix6 transition = identity + a * mean;
  carry_heading(rate_nb, dt);
  x_ = transition * x_ + mean.leftCols<3>() * (specific_force * dt);

  p_ = transition * p_ * transition.transpose();
  p_.diagonal().head<3>().array() += std::pow(options_.velocity_noise, 2) * dt;
  p_.diagonal().tail<3>().array() += std::pow(options_.alpha_noise, 2) * dt;
  p_ = (0.5 * (p_ + p_.transpose())).eval();
}

void LevelingFilter::update_moving(double speed_mps) {
  const Vector3d alpha = x_.tail<3>();
  Eigen::Matrix<double, 2, 6> h = Eigen::Matrix<double, 2, 6>::Zero();  // eq. (30)
  h(0, 0) = 1;
  h.row(1).tail<3>() = 2 * alpha.transpose();
  update<2>({speed_mps - x_(0), 1 - alpha.squaredNorm()}, h,  // eq. (31), brackets put right
            {std::pow(options_.speed_sigma_mps, 2), std::pow(options_.norm_sigma, 2)});
}

void LevelingFilter::update_stationary() {
  const Vector3d alpha = x_.tail<3>();
  Eigen::Matrix<double, 4, 6> h = Eigen::Matrix<double, 4, 6>::Zero();  // eq. (33)
  h.topLeftCorner<3, 3>().setIdentity();
  h.row(3).tail<3>() = 2 * alpha.transpose();
  const double velocity_variance = std::pow(options_.stationary_sigma_mps, 2);
  update<4>(
      {-x_(0), -x_(1), -x_(2), 1 - alpha.squaredNorm()}, h,  // eq. (34)
      {velocity_variance, velocity_variance, velocity_variance, std::pow(options_.norm_sigma, 2)});
}

void LevelingFilter::update_nonholonomic(double dt) {
  using Row = Eigen::Matrix<double, 1, 6>;
  using Scalar = Eigen::Matrix<double, 1, 1>;
  const auto hold_at_zero = [&](int axis, double density) {
    update<1>(Scalar{-x_(axis)}, Row::Unit(axis), Scalar{density * density / dt});
  };
  if (options_.transverse_speed_density) hold_at_zero(1, *options_.transverse_speed_density);
  if (options_.vertical_speed_density) hold_at_zero(2, *options_.vertical_speed_density);
}

template <int Rows>
void LevelingFilter::update(const Eigen::Matrix<double, Rows, 1>& residual,
                            const Eigen::Matrix<double, Rows, 6>& h,
                            const Eigen::Matrix<double, Rows, 1>& variance) {
  using Square = Eigen::Matrix<double, Rows, Rows>;
  const Square r = variance.asDiagonal();
  const Square inverse = Square{h * p_ * h.transpose() + r}.inverse();
  const Eigen::Matrix<double, 6, Rows> gain = p_ * h.transpose() * inverse;  // eq. (25)
  x_ += gain * residual;                                                     // eq. (23)

  // Joseph's form of eq. (24): stays symmetric and positive whatever the rounding.
  const Matrix6 kept = Matrix6::Identity() - gain * h;
  p_ = (kept * p_ * kept.transpose() + gain * r * gain.transpose()).eval();

  innovation_.residual.setZero();
  innovation_.residual.head<Rows>() = residual;
  innovation_.size = Rows;
  innovation_.normalised_square = residual.dot(inverse * residual);
}

double LevelingFilter::roll() const { return std::atan2(x_(4), x_(5)); }

double LevelingFilter::pitch() const { return std::atan2(-x_(3), std::hypot(x_(4), x_(5))); }

Eigen::Matrix2d LevelingFilter::roll_pitch_covariance() const {
  const Vector3d alpha = x_.tail<3>();
  const double across = std::max(std::hypot(alpha.y(), alpha.z()), vertical);
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << 0, alpha.z() / (across * across), -alpha.y() / (across * across),  //
      -across, alpha.x() * alpha.y() / across, alpha.x() * alpha.z() / across;
  jacobian.row(1) /= alpha.squaredNorm();
  return jacobian * p_.bottomRightCorner<3, 3>() * jacobian.transpose();
}

Vector3d LevelingFilter::earth_rate_body() const {
  return frame::ned_to_body({roll(), pitch(), heading_}) * earth_rate_ned_;
}

void LevelingFilter::carry_heading(const Vector3d& rate_nb, double dt) {
  // Third row of eq. (3) in terms of alpha: (q sin(roll) + r cos(roll)) / cos(pitch).
  const Vector3d alpha = x_.tail<3>().normalized();
  const double across_squared = alpha.y() * alpha.y() + alpha.z() * alpha.z();
  if (across_squared < vertical) return;
  const double rate = (rate_nb.y() * alpha.y() + rate_nb.z() * alpha.z()) / across_squared;
  heading_ = frame::wrap_pi(heading_ + rate * dt);
}

}  // namespace drydock::leveling
