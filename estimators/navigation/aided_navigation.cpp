#include "estimators/navigation/aided_navigation.hpp"

#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/local_earth.hpp"

namespace drydock::navigation {

using Eigen::Vector3d;

namespace {

ErrorFilter<0>::Vector padded(const Vector15& values) {
  ErrorFilter<0>::Vector all = ErrorFilter<0>::Vector::Zero();
  all.head<15>() = values;
  return all;
}

}  // namespace

Vector15 initial_sigma(const NavigationOptions& o, const frame::Position& at) {
  const frame::LocalEarth earth = frame::local_earth(at.latitude_rad, at.height_m);
  Vector15 sigma;
  sigma << o.position_m / (earth.meridian_radius_m + at.height_m),
      o.position_m / ((earth.transverse_radius_m + at.height_m) * earth.cos_latitude), o.height_m,
      Vector3d::Constant(o.velocity_mps), o.alignment_rad, Vector3d::Constant(o.gyro_bias_radps),
      Vector3d::Constant(o.accel_bias_mps2);
  return sigma;
}

Vector15 noise_density(const NavigationOptions& o) {
  Vector15 root;
  root << 0, 0, o.height_noise_m, Vector3d::Constant(o.velocity_noise_mps),
      Vector3d::Constant(o.angle_noise_rad), Vector3d::Constant(o.gyro_bias_walk_radps),
      Vector3d::Constant(o.accel_bias_walk_mps2);
  return root.array().square();
}

HeightLoop height_loop(const NavigationOptions& o) {
  return o.height_loop_tau_s > 0 ? HeightLoop::of_time_constant(o.height_loop_tau_s) : HeightLoop{};
}

Eigen::Matrix<double, 3, 6> body_velocity_rows(const NavigationState& state) {
  const Eigen::Matrix3d ned_to_body = state.body_to_ned.toRotationMatrix().transpose();
  Eigen::Matrix<double, 3, 6> rows;
  rows << ned_to_body, -ned_to_body * frame::skew(state.velocity_ned);
  return rows;
}

HeadingRow heading_row(const Eigen::Quaterniond& body_to_ned) {
  const Vector3d bow = body_to_ned * Vector3d::UnitX();
  const double level = bow.head<2>().norm();
  const Eigen::Vector2d by_tilt = bow.z() / (level * level) * bow.head<2>();
  return {std::atan2(bow.y(), bow.x()), level, {by_tilt.x(), by_tilt.y(), -1}};
}

AidedNavigation::AidedNavigation(const NavigationState& start, const NavigationOptions& options)
    : options_(options),
      sdins_(start, height_loop(options)),
      filter_(padded(initial_sigma(options, start.position))),
      noise_(padded(noise_density(options))) {}

void AidedNavigation::add_imu(const Vector3d& angle, const Vector3d& velocity, double dt) {
  sum_.add(angle - gyro_bias_ * dt, velocity - accel_bias_ * dt, dt);
}

void AidedNavigation::step(std::optional<double> reference_height_m) {
  const Increments increments = sum_.take();
  if (!(increments.dt > 0)) return;
  rate_ = increments.rotation / increments.dt;
  sdins_.step(increments, reference_height_m);
  filter_.propagate(error_dynamics(sdins_.state(), sdins_.force_ned(), sdins_.loop()),
                    increments.dt, noise_);
}

void AidedNavigation::add_noise(const Vector3d& angle, const Vector3d& velocity) {
  const Eigen::Matrix3d turn = sdins_.state().body_to_ned.toRotationMatrix();
  auto& p = filter_.covariance();
  p.block<3, 3>(phi, phi) += turn * angle.cwiseAbs2().asDiagonal() * turn.transpose();
  p.block<3, 3>(velocity_error, velocity_error) +=
      turn * velocity.cwiseAbs2().asDiagonal() * turn.transpose();
}

int AidedNavigation::update_velocity(const Vector3d& velocity_body, const Vector3d& sigma,
                                     const Vector3d& lever) {
  const NavigationState& now = sdins_.state();
  const Vector3d residual =
      now.body_to_ned.conjugate() * now.velocity_ned + rate_.cross(lever) - velocity_body;
  const auto rows = body_velocity_rows(now);
  const Eigen::Matrix3d by_gyro_bias = -frame::skew(lever);  // eq. (N8)
  Vector errors = Vector::Zero();
  int used = 0;
  innovations_.clear();
  for (int axis = 0; axis < 3; ++axis) {
    Vector row = Vector::Zero();
    row.segment<6>(velocity_error) = rows.row(axis);
    row.segment<3>(navigation::gyro_bias) = by_gyro_bias.row(axis);
    used += update_row(row, residual(axis), sigma(axis) * sigma(axis), errors);
  }
  feed_back(errors);
  return used;
}

int AidedNavigation::update_height(double height_m, double sigma, const Vector3d& lever) {
  const Vector3d arm = sdins_.state().body_to_ned * lever;
  Vector errors = Vector::Zero(), row = Vector::Unit(position_error + 2);
  row.segment<3>(phi) = -frame::skew(arm).row(2);  // eq. (N8); height is up
  innovations_.clear();
  const int used =
      update_row(row, sdins_.state().position.height_m - arm.z() - height_m, sigma * sigma, errors);
  feed_back(errors);
  return used;
}

int AidedNavigation::update_heading(double heading_rad, double sigma) {
  constexpr double least_level = 0.1;
  const HeadingRow now = heading_row(sdins_.state().body_to_ned);
  innovations_.clear();
  if (now.level < least_level) return 0;
  Vector errors = Vector::Zero(), row = Vector::Zero();
  row.segment<3>(phi) = now.by_phi;
  const double residual = frame::wrap_pi(now.heading_rad - heading_rad);
  const int used = update_row(row, residual, sigma * sigma, errors);
  feed_back(errors);
  return used;
}

int AidedNavigation::update_position(const frame::Position& position, const Vector3d& sigma,
                                     const Vector3d& lever) {
  const frame::Position& now = sdins_.state().position;
  const frame::LocalEarth earth = frame::local_earth(now.latitude_rad, now.height_m);
  // Factors from metres north, east, down to rad, rad, metres up.
  const Vector3d unit{1 / (earth.meridian_radius_m + now.height_m),
                      1 / ((earth.transverse_radius_m + now.height_m) * earth.cos_latitude), -1};
  const Vector3d arm = sdins_.state().body_to_ned * lever;
  const Vector3d residual = Vector3d{now.latitude_rad - position.latitude_rad,
                                     frame::wrap_pi(now.longitude_rad - position.longitude_rad),
                                     now.height_m - position.height_m} +
                            unit.cwiseProduct(arm);
  const Eigen::Matrix3d by_phi = unit.asDiagonal() * frame::skew(arm);  // eq. (N8)
  Vector errors = Vector::Zero();
  int used = 0;
  innovations_.clear();
  for (int axis = 0; axis < 3; ++axis) {
    Vector row = Vector::Unit(position_error + axis);
    row.segment<3>(phi) = by_phi.row(axis);
    used +=
        update_row(row, residual(axis), std::pow(sigma(axis) * unit(axis), 2), errors, unit(axis));
  }
  feed_back(errors);
  return used;
}

int AidedNavigation::update_row(const Vector& row, double residual, double variance, Vector& errors,
                                double unit) {
  const double innovation = residual - row.dot(errors);
  const auto expected = filter_.row(row, variance);
  const double square = innovation * innovation / expected.variance;
  const bool outside = outside_gate(square, options_.gate_sigma);
  innovations_.push_back(
      {-innovation / unit, std::sqrt(expected.variance) / std::abs(unit), !outside});
  if (outside) {
    ++rejected_;
    return 0;
  }
  taken_.add(square);
  errors += filter_.update(expected, innovation);
  return 1;
}

bool AidedNavigation::passes_height(double residual_m, double sigma) {
  const double variance = filter_.row(Vector::Unit(position_error + 2), sigma * sigma).variance;
  const bool outside = outside_gate(residual_m * residual_m / variance, options_.gate_sigma);
  innovations_.assign(1, {residual_m, std::sqrt(variance), !outside});
  if (outside) ++rejected_;
  return !outside;
}

double AidedNavigation::innovation_square() const {
  double sum = 0;
  for (const Innovation& row : innovations_) sum += row.normalised_square();
  return sum;
}

void AidedNavigation::loosen(double velocity_sigma_mps, double angle_sigma_rad) {
  filter_.loosen(velocity_sigma_mps, angle_sigma_rad);
}

void AidedNavigation::loosen_position(double sigma_m) {
  const frame::Position& now = sdins_.state().position;
  const frame::LocalEarth earth = frame::local_earth(now.latitude_rad, now.height_m);
  auto variance = filter_.covariance().diagonal();
  variance(position_error) += std::pow(sigma_m / (earth.meridian_radius_m + now.height_m), 2);
  variance(position_error + 1) +=
      std::pow(sigma_m / ((earth.transverse_radius_m + now.height_m) * earth.cos_latitude), 2);
}

void AidedNavigation::loosen_biases(double gyro_sigma_radps, double accel_sigma_mps2) {
  filter_.loosen_biases(gyro_sigma_radps, accel_sigma_mps2);
}

void AidedNavigation::feed_back(const Vector& errors) {
  sdins_.correct(errors.segment<3>(position_error), errors.segment<3>(velocity_error),
                 errors.segment<3>(phi));
  gyro_bias_ += errors.segment<3>(navigation::gyro_bias);
  accel_bias_ += errors.segment<3>(navigation::accel_bias);
}

}  // namespace drydock::navigation
