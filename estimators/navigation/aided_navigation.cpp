#include "estimators/navigation/aided_navigation_body.hpp"

#include <cmath>

#include "estimators/frame/attitude.hpp"

namespace drydock::navigation {

using Eigen::Vector3d;

Vector15 initial_sigma(const NavigationOptions& o, const frame::Position& at) {
  return basic_initial_sigma<double>(o, at);
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

HeadingRow heading_row(const Eigen::Quaterniond& body_to_ned) {
  const Vector3d bow = body_to_ned * Vector3d::UnitX();
  const double level = bow.head<2>().norm();
  const Eigen::Vector2d by_tilt = bow.z() / (level * level) * bow.head<2>();
  return {std::atan2(bow.y(), bow.x()), level, {by_tilt.x(), by_tilt.y(), -1}};
}

template <>
bool AidedNavigation::passes(double innovation, double variance, double unit) {
  const double square = innovation * innovation / variance;
  const bool outside = outside_gate(square, options_.gate_sigma);
  innovations_.push_back({-innovation / unit, std::sqrt(variance) / std::abs(unit), !outside});
  if (outside) {
    ++rejected_;
    return false;
  }
  taken_.add(square);
  return true;
}

template <>
void AidedNavigation::add_noise(const Vector3d& angle, const Vector3d& velocity) {
  const Eigen::Matrix3d turn = sdins_.state().body_to_ned.toRotationMatrix();
  auto& p = filter_.covariance();
  p.block<3, 3>(phi, phi) += turn * angle.cwiseAbs2().asDiagonal() * turn.transpose();
  p.block<3, 3>(velocity_error, velocity_error) +=
      turn * velocity.cwiseAbs2().asDiagonal() * turn.transpose();
}

template <>
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

template <>
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

template <>
bool AidedNavigation::passes_height(double residual_m, double sigma) {
  const double variance = filter_.row(Vector::Unit(position_error + 2), sigma * sigma).variance;
  const bool outside = outside_gate(residual_m * residual_m / variance, options_.gate_sigma);
  innovations_.assign(1, {residual_m, std::sqrt(variance), !outside});
  if (outside) ++rejected_;
  return !outside;
}

template <>
double AidedNavigation::innovation_square() const {
  double sum = 0;
  for (const Innovation& row : innovations_) sum += row.normalised_square();
  return sum;
}

template <>
void AidedNavigation::loosen(double velocity_sigma_mps, double angle_sigma_rad) {
  filter_.loosen(velocity_sigma_mps, angle_sigma_rad);
}

template <>
void AidedNavigation::loosen_position(double sigma_m) {
  filter_.loosen_position(sdins_.state().position, sigma_m);
}

template <>
void AidedNavigation::loosen_biases(double gyro_sigma_radps, double accel_sigma_mps2) {
  filter_.loosen_biases(gyro_sigma_radps, accel_sigma_mps2);
}

template Eigen::Matrix<double, 3, 6> body_velocity_rows(const NavigationState&);
template class BasicAidedNavigation<double>;

}  // namespace drydock::navigation
