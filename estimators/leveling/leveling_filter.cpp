#include "estimators/leveling/leveling_filter.hpp"

#include <Eigen/LU>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"

namespace drydock::leveling {

using Eigen::Vector3d;

namespace {

/// A constant error of the rate is covered by noise of alpha: this much noise per rad/s. Chosen.
constexpr double noise_over_rate = 4;  // sqrt(s)

}  // namespace

LevelingFilter::LevelingFilter(const LevelingOptions& options)
    : options_(options),
      gravity_(frame::gravity(options.latitude_rad, options.height_m)),
      earth_rate_(options.latitude_rad),
      alpha_variance_(std::pow(options.alpha_noise, 2)),
      heading_(frame::wrap_pi(options.heading_rad)),
      gate_(options) {}

void LevelingFilter::start(const Vector3d& specific_force, const Vector3d& angular_rate,
                           double speed_mps) {
  alpha_variance_ = std::pow(options_.alpha_noise, 2);
  start_at(first_alpha(options_, specific_force, angular_rate, speed_mps, gravity_,
                       options_.accelerometer_start_alpha_sigma),
           angular_rate.z(), speed_mps);
}

void LevelingFilter::start_again(const Vector3d& specific_force, const Vector3d& angular_rate,
                                 double speed_mps, double silent_s) {
  start_at(first_alpha(options_, specific_force, angular_rate, speed_mps, gravity_,
                       options_.restart_alpha_sigma),
           angular_rate.z(), speed_mps);
  earth_rate_.forget_heading(options_.unseen_turn_radps * silent_s);
  alpha_variance_ =
      std::pow(options_.alpha_noise, 2) + std::pow(noise_over_rate, 2) * earth_rate_.variance();
}

void LevelingFilter::start_at(const FirstAlpha& first, double turn_radps, double speed_mps) {
  x_ << speed_mps, 0, 0, first.alpha;
  p_.setZero();
  p_.diagonal().head<3>().setConstant(std::pow(options_.initial_velocity_sigma_mps, 2));
  p_.diagonal().tail<3>().setConstant(first.sigma * first.sigma);
  turn_ = turn_radps;
  innovation_ = {};
  gate_.start();
}

void LevelingFilter::loosen(double velocity_sigma_mps, double angle_sigma_rad) {
  p_.diagonal().head<3>().array() += velocity_sigma_mps * velocity_sigma_mps;
  p_.diagonal().tail<3>().array() += angle_sigma_rad * angle_sigma_rad;
}

void LevelingFilter::loosen_biases(double rate_sigma_radps, double force_sigma_mps2) {
  // Without bias states the bias of an accelerometer is a tilt, and that of a gyro is noise.
  p_.diagonal().tail<3>().array() += std::pow(force_sigma_mps2 / gravity_, 2);
  alpha_variance_ += std::pow(noise_over_rate * rate_sigma_radps, 2);
}

void LevelingFilter::loosen_log(double speed_sigma_mps) {
  p_(0, 0) += speed_sigma_mps * speed_sigma_mps;
}

void LevelingFilter::predict(const Vector3d& specific_force, const Vector3d& angular_rate,
                             double dt) {
  const Vector3d earth_rate = earth_rate_body();             // eq. (16)
  const Vector3d rate_nb = angular_rate - earth_rate;        // eq. (17)
  const Vector3d rate_coriolis = angular_rate + earth_rate;  // eq. (15)

  alpha_variance_ +=
      std::pow(noise_over_rate, 2) * earth_rate_.drift(options_.gyro_bias_sigma_radps, dt);
  turn_ = angular_rate.z();
  const Transition transition(system_matrix(rate_nb, rate_coriolis, gravity_), dt);
  heading_ = carried_heading(heading_, x_.tail<3>(), rate_nb, dt);
  x_ = transition.step * x_ + transition.mean.leftCols<3>() * (specific_force * dt);

  p_ = transition.step * p_ * transition.step.transpose();
  p_.diagonal().head<3>().array() += std::pow(options_.velocity_noise, 2) * dt;
  p_.diagonal().tail<3>().array() += (alpha_variance_ + turn_noise(options_, rate_nb)) * dt;
  p_ = (0.5 * (p_ + p_.transpose())).eval();
}

void LevelingFilter::update_moving(double speed_mps, bool trusted) {
  const Vector3d alpha = x_.tail<3>();
  Eigen::Matrix<double, 2, 6> h = Eigen::Matrix<double, 2, 6>::Zero();  // eq. (30)
  h(0, 0) = 1;
  h.row(1).tail<3>() = 2 * alpha.transpose();
  const Eigen::Vector2d residual{speed_mps - x_(0), 1 - alpha.squaredNorm()};  // sign corrected
  const Eigen::Vector2d variance{std::pow(options_.speed_sigma_mps, 2),
                                 std::pow(options_.norm_sigma, 2)};
  const double expected = p_(0, 0) + variance(0);
  if (trusted && gate_.passes(residual(0), expected, p_(0, 0))) {
    update<2>(residual, h, variance);  // eq. (31)
    innovation_.log = {residual(0), std::sqrt(expected), true};
  } else {
    update<1>(residual.tail<1>(), h.bottomRows<1>(), variance.tail<1>());
    innovation_.log = {residual(0), std::sqrt(expected), false};
  }
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
  const auto hold_at_zero = [&](int axis, double variance) {
    const double normalised = -x_(axis) / std::sqrt(p_(axis, axis) + variance);
    update<1>(Scalar{-x_(axis)}, Row::Unit(axis), Scalar{variance});
    return normalised;
  };
  const Nonholonomic allowed(options_, turn_, dt);
  constraints_ = {};
  if (allowed.transverse) constraints_.transverse = hold_at_zero(1, *allowed.transverse);
  if (allowed.vertical) constraints_.vertical = hold_at_zero(2, *allowed.vertical);
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

  // Joseph's form of eq. (24) stays symmetric and positive in spite of rounding.
  const Matrix6 kept = Matrix6::Identity() - gain * h;
  p_ = (kept * p_ * kept.transpose() + gain * r * gain.transpose()).eval();

  innovation_ = {};
  innovation_.residual.head<Rows>() = residual;
  innovation_.size = Rows;
  innovation_.normalised_square = residual.dot(inverse * residual);
}

double LevelingFilter::roll() const { return roll_of(x_.tail<3>()); }

double LevelingFilter::pitch() const { return pitch_of(x_.tail<3>()); }

Eigen::Matrix2d LevelingFilter::roll_pitch_covariance() const {
  return leveling::roll_pitch_covariance(x_.tail<3>(), p_.bottomRightCorner<3, 3>());
}

Vector3d LevelingFilter::earth_rate_body() const {
  return frame::ned_to_body({roll(), pitch(), heading_}) * earth_rate_.ned();
}

}  // namespace drydock::leveling
