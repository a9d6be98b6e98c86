#include "estimators/leveling/augmented_leveling_filter.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/leveling/level_kinematics.hpp"

namespace drydock::leveling {

using Eigen::Vector3d;
using frame::skew;

namespace {

constexpr int alpha_at = 3, accelerometer_at = 6, gyro_at = 9, log_at = 12;

/// d(x')/d(b) of eq. (A2): the effect of the six inertial biases on V and alpha. The bias of the
/// log has no effect.
Matrix6 bias_matrix(const Vector3d& velocity, const Vector3d& alpha) {
  Matrix6 g = Matrix6::Zero();
  g.topLeftCorner<3, 3>() = -Eigen::Matrix3d::Identity();
  g.topRightCorner<3, 3>() = -skew(velocity);
  g.bottomRightCorner<3, 3>() = -skew(alpha);
  return g;
}

double squared(double x) { return x * x; }

}  // namespace

AugmentedLevelingFilter::AugmentedLevelingFilter(const LevelingOptions& options)
    : options_(options),
      gravity_(frame::gravity(options.latitude_rad, options.height_m)),
      earth_rate_(options.latitude_rad),
      heading_(frame::wrap_pi(options.heading_rad)),
      gate_(options) {}

void AugmentedLevelingFilter::start(const Vector3d& specific_force, const Vector3d& angular_rate,
                                    double speed_mps) {
  x_.setZero();
  Eigen::Matrix<double, 7, 1> sigma;
  sigma << Vector3d::Constant(options_.accelerometer_bias_sigma_mps2),
      Vector3d::Constant(options_.gyro_bias_sigma_radps), options_.speed_bias_sigma_mps;
  p_.bottomRightCorner<7, 7>() = sigma.cwiseAbs2().asDiagonal();
  start_motion(first_alpha(options_, specific_force, angular_rate, speed_mps, gravity_,
                           options_.accelerometer_start_alpha_sigma),
               angular_rate.z(), speed_mps);
}

void AugmentedLevelingFilter::start_again(const Vector3d& specific_force,
                                          const Vector3d& angular_rate, double speed_mps,
                                          double silent_s) {
  const Vector3d force = specific_force - accelerometer_bias(), rate = angular_rate - gyro_bias();
  const double speed = speed_mps - speed_bias();
  start_motion(first_alpha(options_, force, rate, speed, gravity_, options_.restart_alpha_sigma),
               rate.z(), speed);
  earth_rate_.forget_heading(options_.unseen_turn_radps * silent_s);
  widen_gyro_bias();
}

void AugmentedLevelingFilter::start_motion(const FirstAlpha& first, double turn_radps,
                                           double speed_mps) {
  x_.head<6>() << speed_mps, 0, 0, first.alpha;
  Vector6 sigma;
  sigma << Vector3d::Constant(options_.initial_velocity_sigma_mps), Vector3d::Constant(first.sigma);
  p_.topRows<6>().setZero();
  p_.leftCols<6>().setZero();
  p_.diagonal().head<6>() = sigma.cwiseAbs2();
  turn_ = turn_radps;
  innovation_ = {};
  gate_.start();
}

void AugmentedLevelingFilter::widen_gyro_bias() {
  const double open = earth_rate_.variance();
  p_.diagonal().segment<3>(gyro_at).array() += open;
  // The variance is limited to that of a new gyro plus that of the Earth's rate. Repeated losses of
  // the heading cannot make it larger.
  const double most = squared(options_.gyro_bias_sigma_radps) + open;
  for (int axis = gyro_at; axis < log_at; ++axis) {
    const double scale = std::sqrt(std::min(1.0, most / p_(axis, axis)));
    p_.row(axis) *= scale;
    p_.col(axis) *= scale;
  }
}

void AugmentedLevelingFilter::let_biases_wander(double dt) {
  if (options_.gyro_bias_walk_radps == 0 && options_.accelerometer_bias_walk_mps2 == 0) return;
  loosen_biases(options_.gyro_bias_walk_radps * std::sqrt(dt),
                options_.accelerometer_bias_walk_mps2 * std::sqrt(dt));
}

void AugmentedLevelingFilter::loosen(double velocity_sigma_mps, double angle_sigma_rad) {
  p_.diagonal().head<3>().array() += squared(velocity_sigma_mps);
  p_.diagonal().segment<3>(alpha_at).array() += squared(angle_sigma_rad);
}

void AugmentedLevelingFilter::loosen_biases(double rate_sigma_radps, double force_sigma_mps2) {
  p_.diagonal().segment<3>(accelerometer_at).array() += squared(force_sigma_mps2);
  p_.diagonal().segment<3>(gyro_at).array() += squared(rate_sigma_radps);
}

void AugmentedLevelingFilter::loosen_log(double speed_sigma_mps) {
  p_(log_at, log_at) += squared(speed_sigma_mps);
}

void AugmentedLevelingFilter::predict(const Vector3d& specific_force, const Vector3d& angular_rate,
                                      double dt) {
  const Vector3d velocity = x_.head<3>(), alpha = x_.segment<3>(alpha_at);
  const Vector3d force = specific_force - accelerometer_bias();  // eq. (A1)
  const Vector3d rate = angular_rate - gyro_bias();
  const Vector3d earth_rate =
      frame::ned_to_body({roll(), pitch(), heading_}) * earth_rate_.ned();  // eq. (16)

  const double opened = earth_rate_.drift(options_.gyro_bias_sigma_radps, dt);
  turn_ = rate.z();
  const Transition transition(system_matrix(rate - earth_rate, rate + earth_rate, gravity_), dt);
  heading_ = carried_heading(heading_, alpha, rate - earth_rate, dt);
  x_.head<6>() =
      (transition.step * x_.head<6>() + transition.mean.leftCols<3>() * (force * dt)).eval();

  // Eq. (A3) in blocks: motion, motion with biases, biases. The block of the biases is constant.
  const Matrix6& s = transition.step;
  const Matrix6 b = transition.mean * bias_matrix(velocity, alpha) * dt;
  const Eigen::Matrix<double, 6, 7> cross = p_.topRightCorner<6, 7>();
  const Matrix6 half = s * p_.topLeftCorner<6, 6>() + b * cross.leftCols<6>().transpose();
  const Eigen::Matrix<double, 6, 7> carried = s * cross + b * p_.block<6, 7>(6, 6);
  const Matrix6 motion = half * s.transpose() + carried.leftCols<6>() * b.transpose();
  p_.topLeftCorner<6, 6>() = 0.5 * (motion + motion.transpose());
  p_.topRightCorner<6, 7>() = carried;
  p_.bottomLeftCorner<7, 6>() = carried.transpose();
  p_.diagonal().head<3>().array() += squared(options_.velocity_noise) * dt;
  p_.diagonal().segment<3>(alpha_at).array() +=
      (squared(options_.alpha_noise) + turn_noise(options_, rate)) * dt;
  let_biases_wander(dt);
  // Eq. (A9): this part of the bias is fixed to the Earth, so it rotates in the body.
  p_.diagonal().segment<3>(gyro_at).array() +=
      opened + earth_rate_.variance() * std::abs(turn_) * dt;
}

void AugmentedLevelingFilter::update_moving(double speed_mps, bool trusted) {
  begin_update();
  const State row = State::Unit(0) + State::Unit(log_at);
  const double residual = speed_mps - row.dot(x_), variance = squared(options_.speed_sigma_mps);
  const double expected = row.dot(p_ * row) + variance;
  const bool used = trusted && gate_.passes(residual, expected, p_(0, 0));
  innovation_.log = {residual, std::sqrt(expected), used};
  if (used) update(residual, row, variance);
  update_norm();
}

navigation::Innovation AugmentedLevelingFilter::update_velocity(int axis, double speed_mps,
                                                                double sigma_mps, bool used) {
  begin_update();
  const double residual = speed_mps - x_(axis), variance = squared(sigma_mps);
  const navigation::Innovation innovation{residual, std::sqrt(p_(axis, axis) + variance), used};
  if (!used) return innovation;
  update(residual, State::Unit(axis), variance);
  update_norm();
  return innovation;
}

void AugmentedLevelingFilter::update_stationary() {
  begin_update();
  for (int axis = 0; axis < 3; ++axis)
    update(-x_(axis), State::Unit(axis), squared(options_.stationary_sigma_mps));
  update_norm();
}

void AugmentedLevelingFilter::update_nonholonomic(double dt) {
  begin_update();
  const Nonholonomic allowed(options_, turn_, dt);
  const auto hold_at_zero = [this](int axis, double variance) {
    const double normalised = -x_(axis) / std::sqrt(p_(axis, axis) + variance);
    update(-x_(axis), State::Unit(axis), variance);
    return normalised;
  };
  constraints_ = {};
  if (allowed.transverse) constraints_.transverse = hold_at_zero(1, *allowed.transverse);
  if (allowed.vertical) constraints_.vertical = hold_at_zero(2, *allowed.vertical);
}

void AugmentedLevelingFilter::update_norm() {
  const Vector3d alpha = x_.segment<3>(alpha_at);
  State row = State::Zero();
  row.segment<3>(alpha_at) = 2 * alpha;
  update(1 - alpha.squaredNorm(), row, squared(options_.norm_sigma));
}

void AugmentedLevelingFilter::update(double residual, const State& row, double variance) {
  const State seen = p_ * row;
  const double expected = row.dot(seen) + variance;
  const State gain = seen / expected;  // eq. (25)
  x_ += gain * residual;               // eq. (23)

  // Joseph's form of eq. (24), (I - K h) P (I - K h)^T + K r K^T: first the left factor, then the
  // right one.
  Covariance kept = p_ - gain * seen.transpose();
  const State still_seen = kept * row;
  kept += (variance * gain - still_seen) * gain.transpose();
  p_ = 0.5 * (kept + kept.transpose());

  innovation_.residual(innovation_.size++) = residual;
  innovation_.normalised_square += residual * residual / expected;
}

double AugmentedLevelingFilter::roll() const { return roll_of(x_.segment<3>(alpha_at)); }

double AugmentedLevelingFilter::pitch() const { return pitch_of(x_.segment<3>(alpha_at)); }

Eigen::Matrix2d AugmentedLevelingFilter::roll_pitch_covariance() const {
  return leveling::roll_pitch_covariance(x_.segment<3>(alpha_at),
                                         p_.block<3, 3>(alpha_at, alpha_at));
}

}  // namespace drydock::leveling
