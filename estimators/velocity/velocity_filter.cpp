#include "estimators/velocity/velocity_filter.hpp"

namespace drydock::velocity {

using Eigen::Vector3d;
using hydrodynamics::Matrix6;

VelocityFilter::VelocityFilter(const hydrodynamics::Model& model, const Simulated& start,
                               const VelocityFilterOptions& options)
    : simulator_(model, start), options_(options) {
  Vector sigma;
  sigma << options.height_sigma_m, Vector3d::Constant(options.velocity_sigma_mps),
      Vector3d::Constant(options.rate_sigma_radps), 0;
  p_.diagonal() = sigma.array().square();
}

void VelocityFilter::predict(const Setting& setting, const hydrodynamics::Control& control,
                             double dt) {
  // A_k = I + T A, eq. (7): what a small error of V and omega becomes within the step.
  Matrix6 a =
      dt * simulator_.model().velocity_partials(simulator_.state().velocity, setting.ned_to_body,
                                                control, setting.earth_rate_ned);
  a.diagonal().array() += 1;
  const Vector3d climb = -dt * setting.ned_to_body.col(2);
  simulator_.step(setting, control, dt);

  // P A': the column of h, then the six others.
  Covariance right = p_;
  right.col(0).noalias() += p_.middleCols<3>(1) * climb;
  right.middleCols<6>(1).noalias() = p_.middleCols<6>(1) * a.transpose();
  const Covariance left = right.transpose();
  p_ = left;
  p_.col(0).noalias() += left.middleCols<3>(1) * climb;
  p_.middleCols<6>(1).noalias() = left.middleCols<6>(1) * a.transpose();
  p_.row(0) = p_.col(0).transpose();
  p_ = (0.5 * (p_ + p_.transpose())).eval();

  Vector noise;
  noise << options_.height_noise_mps, options_.velocity_noise_mps2,
      Vector3d::Constant(options_.rate_noise_radps2), 0;
  p_.diagonal().array() += (dt * noise).array().square();
}

bool VelocityFilter::update_height(double height_m) {
  return update_state(0, height_m - simulator_.state().height_m, options_.depth_sigma_m);
}

void VelocityFilter::update_rate(const Vector3d& rate) {
  const double variance = options_.gyro_sigma_radps * options_.gyro_sigma_radps;
  for (int i = 4; i < 7; ++i)  // no gate: the navigation believes its gyros as well
    apply(p_.col(i), p_(i, i) + variance, rate(i - 4) - simulator_.state().velocity(i - 1));
}

void VelocityFilter::update_velocity(const Vector3d& velocity) {
  for (int i = 0; i < 3; ++i)
    update_state(1 + i, velocity(i) - simulator_.state().velocity(i), options_.ground_sigma_mps);
}

void VelocityFilter::update_log(double speed_mps) {
  constexpr double slowest = 1e-3;  // below it the speed says nothing of a direction
  const double speed = velocity().norm();
  if (speed < slowest) return;
  const Vector3d direction = velocity() / speed;  // row 2 of C_k
  const Vector cross = p_.middleCols<3>(1) * direction;
  const double variance =
      direction.dot(cross.segment<3>(1)) + options_.log_sigma_mps * options_.log_sigma_mps;
  if (passes(speed_mps - speed, variance)) apply(cross, variance, speed_mps - speed);
}

void VelocityFilter::update_longitudinal(double mps) {
  update_state(1, mps - velocity().x(), options_.log_sigma_mps);
}

bool VelocityFilter::passes(double residual, double innovation_variance) {
  const double square = residual * residual / innovation_variance;
  const bool outside =
      options_.gate_sigma > 0 && square > options_.gate_sigma * options_.gate_sigma;
  if (outside) ++rejected_;
  return !outside;
}

bool VelocityFilter::update_state(int index, double residual, double sigma) {
  const double variance = p_(index, index) + sigma * sigma;
  if (!passes(residual, variance)) return false;
  apply(p_.col(index), variance, residual);
  return true;
}

void VelocityFilter::apply(const Vector& cross, double innovation_variance, double residual) {
  const Vector gain = cross / innovation_variance;
  const Vector b = cross - innovation_variance / 2 * gain;
  for (int j = 0; j < 8; ++j) p_.col(j) -= gain * b(j) + b * gain(j);  // Joseph, for one row
  simulator_.state().height_m += gain(0) * residual;
  simulator_.state().velocity += gain.segment<6>(1) * residual;
}

}  // namespace drydock::velocity
