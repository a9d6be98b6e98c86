#include "estimators/pipeline/inertial/paper_inertial.hpp"

#include <cmath>

#include "estimators/frame/earth.hpp"

namespace drydock::pipeline {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double filtered_height_sigma_m = 0.05;  ///< of the velocity filter's height
constexpr double velocity_floor_mps = 0.01;       ///< added to P^v: R of eq. (16)

/// The errors of the filtered velocity last for about a second, and a window wants them apart.
constexpr double compare_every_s = 1;

velocity::Simulated simulated_at(const navigation::NavigationState& start) {
  velocity::Simulated simulated{.height_m = start.position.height_m};
  simulated.velocity << start.body_to_ned.conjugate() * start.velocity_ned, Vector3d::Zero();
  return simulated;
}

velocity::VelocityFilterOptions filter_options(const InertialOptions& options) {
  velocity::VelocityFilterOptions filter;
  filter.depth_sigma_m = options.depth_sigma_m;
  filter.log_sigma_mps = options.log_sigma_mps;
  filter.ground_sigma_mps = options.ground_sigma_mps;
  filter.gyro_sigma_radps = options.navigation.angle_noise_rad / std::sqrt(options.imu_period_s);
  filter.gate_sigma = options.navigation.gate_sigma;
  return filter;
}

}  // namespace

PaperInertial::PaperInertial(const InertialOptions& options)
    : aided_(options.start, options.navigation),
      filter_(hydrodynamics::Model(options.vehicle), simulated_at(options.start),
              filter_options(options)),
      earth_rate_(frame::earth_rate_ned(options.start.position.latitude_rad)) {}

void PaperInertial::add_imu(const Vector3d& angle, const Vector3d& velocity, double dt) {
  filter_.predict(setting(), control_, dt);
  aided_.add_imu(angle, velocity, dt);
  elapsed_s_ += dt;
  const velocity::Setting now = setting();
  filter_.update_rate(angle / dt - aided_.gyro_bias() - now.ned_to_body * now.earth_rate_ned);
}

Innovations PaperInertial::add_height(double height_m) {
  if (filter_.update_height(height_m)) {
    height_sum_ += height_m;
    ++heights_;
  }
  return filter_.innovations();
}

Innovations PaperInertial::settle() {
  if (heights_ > 0) {
    aided_.step(height_sum_ / heights_);
  } else {
    aided_.step();
  }
  height_sum_ = heights_ = 0;
  earth_rate_ = frame::earth_rate_ned(state().position.latitude_rad);
  aided_.update_height(filter_.state().height_m, filtered_height_sigma_m);
  const Vector3d variance =
      filter_.velocity_sigma().array().square() + velocity_floor_mps * velocity_floor_mps;
  compared_s_ += elapsed_s_;
  Innovations compared;
  if (compared_s_ >= compare_every_s) {
    compared_s_ = 0;
    compared = compare(variance);
  }
  if (!doubted_)
    by_model_.note(aided_, elapsed_s_,
                   [&] { aided_.update_velocity(filter_.velocity(), variance.cwiseSqrt()); });
  elapsed_s_ = 0;
  return compared;
}

Matrix3d PaperInertial::velocity_covariance() const {
  const Matrix3d ned_to_body = state().body_to_ned.toRotationMatrix().transpose();
  return ned_to_body * aided_.covariance().block<3, 3>(3, 3) * ned_to_body.transpose();
}

Innovations PaperInertial::compare(const Vector3d& model_variance) const {
  const Vector3d off = filter_.velocity() - state().body_to_ned.conjugate() * state().velocity_ned;
  const Matrix3d variance = velocity_covariance();
  Innovations rows;
  for (int i = 0; i < 3; ++i)
    rows.push_back({off(i), std::sqrt(variance(i, i) + model_variance(i)), !doubted_});
  return rows;
}

void PaperInertial::doubt_model(bool doubted) {
  if (doubted && !doubted_) by_model_.doubt(aided_);
  doubted_ = doubted;
}

void PaperInertial::restart_model() {
  velocity::Simulated at = simulated_at(state());
  at.velocity.tail<3>() = filter_.state().velocity.tail<3>();
  filter_.restart(at, velocity_covariance());
}

}  // namespace drydock::pipeline
