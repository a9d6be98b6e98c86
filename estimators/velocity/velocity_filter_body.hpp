#pragma once

#include "estimators/hydrodynamics/model_body.hpp"
#include "estimators/velocity/velocity_filter.hpp"

namespace drydock::velocity {

template <class Real>
BasicVelocityFilter<Real>::BasicVelocityFilter(const hydrodynamics::BasicModel<Real>& model,
                                               const BasicSimulated<Real>& start,
                                               const VelocityFilterOptions& options)
    : simulator_(model, start), options_(options) {
  restart(start,
          Vector3::Constant(options.velocity_sigma_mps * options.velocity_sigma_mps).asDiagonal());
}

template <class Real>
void BasicVelocityFilter<Real>::restart(const BasicSimulated<Real>& at,
                                        const Eigen::Matrix3<Real>& velocity_covariance) {
  simulator_.state() = at;
  Vector sigma;
  sigma << options_.height_sigma_m, Vector3::Zero(), Vector3::Constant(options_.rate_sigma_radps),
      0;
  p_.setZero();
  p_.diagonal() = sigma.array().square();
  p_.template block<3, 3>(1, 1) = velocity_covariance;
}

template <class Real>
void BasicVelocityFilter<Real>::predict(const BasicSetting<Real>& setting,
                                        const hydrodynamics::Control& control, double dt) {
  // A_k = I + T A, eq. (7): the transition of a small error of V and omega over the step.
  hydrodynamics::BasicMatrix6<Real> a =
      dt * simulator_.model().velocity_partials(simulator_.state().velocity, setting.ned_to_body,
                                                control, setting.earth_rate_ned);
  a.diagonal().array() += 1;
  const Vector3 climb = -dt * setting.ned_to_body.col(2);
  simulator_.step(setting, control, dt);

  // The blocks of h and of x = [V, omega] separately: h <- h + climb' V, x <- a x.
  const hydrodynamics::BasicMatrix6<Real> x = p_.template block<6, 6>(1, 1);
  const hydrodynamics::BasicVelocity<Real> by_h = p_.col(0).template segment<6>(1),
                                           climbed = x.template leftCols<3>() * climb;
  const hydrodynamics::BasicVelocity<Real> cross = a * (by_h + climbed);
  const hydrodynamics::BasicMatrix6<Real> right = x * a.transpose(), both = a * right;
  p_(0, 0) += climb.dot((2 * by_h + climbed).template head<3>());
  p_.col(0).template segment<6>(1) = cross;
  p_.row(0).template segment<6>(1) = cross.transpose();
  p_.template block<6, 6>(1, 1) = (both + both.transpose()) / 2;

  Vector noise;
  noise << options_.height_noise_mps, options_.velocity_noise_mps2.template cast<Real>(),
      Vector3::Constant(options_.rate_noise_radps2), 0;
  p_.diagonal().array() += (dt * noise).array().square();
}

template <class Real>
bool BasicVelocityFilter<Real>::update_height(const Real& height_m) {
  innovations_.clear();
  return update_state(0, height_m - simulator_.state().height_m, options_.depth_sigma_m);
}

template <class Real>
void BasicVelocityFilter<Real>::update_rate(const Vector3& rate) {
  const Real variance = options_.gyro_sigma_radps * options_.gyro_sigma_radps;
  for (int i = 4; i < 7; ++i)  // no gate: the navigation uses the gyros without a gate too
    apply(p_.col(i), p_(i, i) + variance, rate(i - 4) - simulator_.state().velocity(i - 1));
}

template <class Real>
void BasicVelocityFilter<Real>::update_velocity(const Vector3& velocity) {
  innovations_.clear();
  for (int i = 0; i < 3; ++i)
    update_state(1 + i, velocity(i) - simulator_.state().velocity(i), options_.ground_sigma_mps);
}

template <class Real>
void BasicVelocityFilter<Real>::update_log(const Real& speed_mps) {
  innovations_.clear();
  constexpr double slowest = 1e-3;  // below it the direction of the velocity is undefined
  const Real speed = velocity().norm();
  if constexpr (lanes::alone<Real>) {
    if (speed < slowest) return;
  }
  const Vector3 direction = velocity() / speed;  // row 2 of C_k
  const Vector cross = p_.template middleCols<3>(1) * direction;
  const Real variance =
      direction.dot(cross.template segment<3>(1)) + options_.log_sigma_mps * options_.log_sigma_mps;
  if constexpr (lanes::alone<Real>) {
    if (!passes(speed_mps - speed, variance)) return;
  }
  apply(cross, variance, speed_mps - speed);
}

template <class Real>
void BasicVelocityFilter<Real>::update_longitudinal(const Real& mps) {
  innovations_.clear();
  update_state(1, mps - velocity().x(), options_.log_sigma_mps);
}

template <class Real>
bool BasicVelocityFilter<Real>::update_state(int index, const Real& residual, double sigma) {
  const Real variance = p_(index, index) + sigma * sigma;
  if constexpr (lanes::alone<Real>) {
    if (!passes(residual, variance)) return false;
  }
  apply(p_.col(index), variance, residual);
  return true;
}

template <class Real>
void BasicVelocityFilter<Real>::apply(const Vector& cross, const Real& innovation_variance,
                                      const Real& residual) {
  using lanes::sqrt;
  const Vector root = cross / sqrt(innovation_variance), gain = cross / innovation_variance;
  for (int j = 0; j < 8; ++j) p_.col(j) -= root(j) * root;
  simulator_.state().height_m += gain(0) * residual;
  simulator_.state().velocity += gain.template segment<6>(1) * residual;
}

}  // namespace drydock::velocity
