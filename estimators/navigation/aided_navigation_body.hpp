#pragma once

#include "estimators/navigation/aided_navigation.hpp"
#include "estimators/navigation/error_model_body.hpp"
#include "estimators/navigation/increments_body.hpp"
#include "estimators/navigation/sdins_body.hpp"

namespace drydock::navigation {

template <class Real>
Eigen::Matrix<Real, 15, 1> basic_initial_sigma(const NavigationOptions& o,
                                               const frame::BasicPosition<Real>& at) {
  using Vector3 = Eigen::Vector3<Real>;
  const frame::BasicLocalEarth<Real> earth = frame::local_earth<Real>(at.latitude_rad, at.height_m);
  Eigen::Matrix<Real, 15, 1> sigma;
  sigma << o.position_m / (earth.meridian_radius_m + at.height_m),
      o.position_m / ((earth.transverse_radius_m + at.height_m) * earth.cos_latitude), o.height_m,
      Vector3::Constant(o.velocity_mps), o.alignment_rad.template cast<Real>(),
      Vector3::Constant(o.gyro_bias_radps), Vector3::Constant(o.accel_bias_mps2);
  return sigma;
}

template <class Real>
Eigen::Matrix<Real, 3, 6> body_velocity_rows(const BasicNavigationState<Real>& state) {
  const Eigen::Matrix3<Real> ned_to_body = state.body_to_ned.toRotationMatrix().transpose();
  Eigen::Matrix<Real, 3, 6> rows;
  rows << ned_to_body, -ned_to_body * frame::skew<Real>(state.velocity_ned);
  return rows;
}

/// Fifteen states, and zero for the one that fills the SIMD words.
template <class Real, class Values>
typename ErrorFilter<0, Real>::Vector padded(const Values& values) {
  typename ErrorFilter<0, Real>::Vector all = ErrorFilter<0, Real>::Vector::Zero();
  all.template head<15>() = values.template cast<Real>();
  return all;
}

template <class Real>
BasicAidedNavigation<Real>::BasicAidedNavigation(const BasicNavigationState<Real>& start,
                                                 const NavigationOptions& options)
    : options_(options),
      sdins_(start, height_loop(options)),
      filter_(padded<Real>(basic_initial_sigma<Real>(options, start.position))),
      noise_(padded<Real>(noise_density(options))),
      earth_rate_ned_(frame::local_earth(start.position.latitude_rad, start.position.height_m)
                          .earth_rate_ned()) {}

template <class Real>
void BasicAidedNavigation<Real>::add_imu(const Vector3& angle, const Vector3& velocity, double dt) {
  sum_.add(angle - gyro_bias_ * dt, velocity - accel_bias_ * dt, dt);
}

template <class Real>
void BasicAidedNavigation<Real>::step(std::optional<Real> reference_height_m) {
  const BasicIncrements<Real> increments = sum_.take();
  if (!(increments.dt > 0)) return;
  rate_ = increments.rotation / increments.dt;
  sdins_.step(increments, reference_height_m);
  const frame::BasicPosition<Real>& at = sdins_.state().position;
  const frame::BasicLocalEarth<Real> earth = frame::local_earth<Real>(at.latitude_rad, at.height_m);
  earth_rate_ned_ = earth.earth_rate_ned();
  filter_.propagate(error_dynamics(sdins_.state(), earth, sdins_.force_ned(), sdins_.loop()),
                    increments.dt, noise_);
}

template <class Real>
int BasicAidedNavigation<Real>::update_velocity(const Vector3& velocity_body, const Vector3& sigma,
                                                const Vector3& lever) {
  const BasicNavigationState<Real>& now = sdins_.state();
  const Vector3 residual =
      now.body_to_ned.conjugate() * now.velocity_ned + rate_.cross(lever) - velocity_body;
  const auto rows = body_velocity_rows(now);
  const Eigen::Matrix3<Real> by_gyro_bias = -frame::skew<Real>(lever);  // eq. (N8)
  Vector errors = Vector::Zero();
  int used = 0;
  innovations_.clear();
  for (int axis = 0; axis < 3; ++axis) {
    Vector row = Vector::Zero();
    row.template segment<6>(velocity_error) = rows.row(axis);
    row.template segment<3>(navigation::gyro_bias) = by_gyro_bias.row(axis);
    used += update_row(row, residual(axis), sigma(axis) * sigma(axis), errors);
  }
  feed_back(errors);
  return used;
}

template <class Real>
int BasicAidedNavigation<Real>::update_height(const Real& height_m, double sigma,
                                              const Vector3& lever) {
  const Vector3 arm = sdins_.state().body_to_ned * lever;
  Vector errors = Vector::Zero(), row = Vector::Unit(position_error + 2);
  row.template segment<3>(phi) = -frame::skew<Real>(arm).row(2);  // eq. (N8); height is up
  innovations_.clear();
  const int used =
      update_row(row, sdins_.state().position.height_m - arm.z() - height_m, sigma * sigma, errors);
  feed_back(errors);
  return used;
}

template <class Real>
int BasicAidedNavigation<Real>::update_row(const Vector& row, const Real& residual,
                                           const Real& variance, Vector& errors, double unit) {
  const Real innovation = residual - row.dot(errors);
  const auto expected = filter_.row(row, variance);
  if constexpr (lanes::alone<Real>) {
    if (!passes(innovation, expected.variance, unit)) return 0;
  }
  errors += filter_.update(expected, innovation);
  return 1;
}

template <class Real>
void BasicAidedNavigation<Real>::feed_back(const Vector& errors) {
  sdins_.correct(errors.template segment<3>(position_error),
                 errors.template segment<3>(velocity_error), errors.template segment<3>(phi));
  gyro_bias_ += errors.template segment<3>(navigation::gyro_bias);
  accel_bias_ += errors.template segment<3>(navigation::accel_bias);
}

}  // namespace drydock::navigation
