#include "estimators/velocity/velocity_filter.hpp"

#include <cmath>

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
  // A_k = I + T A, eq. (7): the transition of a small error of V and omega over the step.
  Matrix6 a =
      dt * simulator_.model().velocity_partials(simulator_.state().velocity, setting.ned_to_body,
                                                control, setting.earth_rate_ned);
  a.diagonal().array() += 1;
  const Vector3d climb = -dt * setting.ned_to_body.col(2);
  simulator_.step(setting, control, dt);

  // The blocks of h and of x = [V, omega] separately: h <- h + climb' V, x <- a x.
  const Matrix6 x = p_.block<6, 6>(1, 1);
  const hydrodynamics::Velocity by_h = p_.col(0).segment<6>(1), climbed = x.leftCols<3>() * climb;
  const hydrodynamics::Velocity cross = a * (by_h + climbed);
  const Matrix6 right = x * a.transpose(), both = a * right;
  p_(0, 0) += climb.dot((2 * by_h + climbed).head<3>());
  p_.col(0).segment<6>(1) = cross;
  p_.row(0).segment<6>(1) = cross.transpose();
  p_.block<6, 6>(1, 1) = (both + both.transpose()) / 2;

  Vector noise;
  noise << options_.height_noise_mps, options_.velocity_noise_mps2,
      Vector3d::Constant(options_.rate_noise_radps2), 0;
  p_.diagonal().array() += (dt * noise).array().square();
}

bool VelocityFilter::update_height(double height_m) {
  innovations_.clear();
  return update_state(0, height_m - simulator_.state().height_m, options_.depth_sigma_m);
}

void VelocityFilter::update_rate(const Vector3d& rate) {
  const double variance = options_.gyro_sigma_radps * options_.gyro_sigma_radps;
  for (int i = 4; i < 7; ++i)  // no gate: the navigation uses the gyros without a gate too
    apply(p_.col(i), p_(i, i) + variance, rate(i - 4) - simulator_.state().velocity(i - 1));
}

void VelocityFilter::update_velocity(const Vector3d& velocity) {
  innovations_.clear();
  for (int i = 0; i < 3; ++i)
    update_state(1 + i, velocity(i) - simulator_.state().velocity(i), options_.ground_sigma_mps);
}

void VelocityFilter::update_log(double speed_mps) {
  innovations_.clear();
  constexpr double slowest = 1e-3;  // below it the direction of the velocity is undefined
  const double speed = velocity().norm();
  if (speed < slowest) return;
  const Vector3d direction = velocity() / speed;  // row 2 of C_k
  const Vector cross = p_.middleCols<3>(1) * direction;
  const double variance =
      direction.dot(cross.segment<3>(1)) + options_.log_sigma_mps * options_.log_sigma_mps;
  if (passes(speed_mps - speed, variance)) apply(cross, variance, speed_mps - speed);
}

void VelocityFilter::update_longitudinal(double mps) {
  innovations_.clear();
  update_state(1, mps - velocity().x(), options_.log_sigma_mps);
}

bool VelocityFilter::passes(double residual, double innovation_variance) {
  const double square = residual * residual / innovation_variance;
  const bool outside =
      options_.gate_sigma > 0 && square > options_.gate_sigma * options_.gate_sigma;
  innovations_.push_back({residual, std::sqrt(innovation_variance), !outside});
  if (outside) {
    ++rejected_;
    return false;
  }
  taken_.add(square);
  return true;
}

bool VelocityFilter::update_state(int index, double residual, double sigma) {
  const double variance = p_(index, index) + sigma * sigma;
  if (!passes(residual, variance)) return false;
  apply(p_.col(index), variance, residual);
  return true;
}

void VelocityFilter::apply(const Vector& cross, double innovation_variance, double residual) {
  const Vector root = cross / std::sqrt(innovation_variance), gain = cross / innovation_variance;
  for (int j = 0; j < 8; ++j) p_.col(j) -= root(j) * root;
  simulator_.state().height_m += gain(0) * residual;
  simulator_.state().velocity += gain.segment<6>(1) * residual;
}

}  // namespace drydock::velocity
