#include "estimators/pipeline/inertial/vehicle_witness.hpp"

#include "estimators/frame/earth.hpp"

namespace drydock::pipeline {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// Without a state of the actuators for this long nothing is known of what moves the vehicle.
constexpr std::chrono::seconds longest_without_control{1};

}  // namespace

void VehicleWitness::add_imu(const Vector3d& angle, const Vector3d& velocity, const Vector3d& rate,
                             double dt) {
  angle_ += angle;
  velocity_ += velocity;
  rate_ = rate;
  elapsed_s_ += dt;
}

void VehicleWitness::control(const hydrodynamics::Control& control, Stamp valid_at) {
  control_ = control;
  controlled_at_ = valid_at;
}

void VehicleWitness::step(const NavigationEstimate& estimate, const Vector3d& gyro_bias) {
  if (!controlled_at_ || estimate.valid_at - *controlled_at_ > longest_without_control) {
    watch_.clear();
  } else if (elapsed_s_ > 0) {
    watch_.add(measured(estimate, gyro_bias), control_, elapsed_s_);
  }
  last_rate_ = rate_;
  last_down_ = estimate.body_to_ned.conjugate() * Vector3d::UnitZ();
  angle_.setZero();
  velocity_.setZero();
  elapsed_s_ = 0;
}

// A filter that estimates no current takes the water as still.
velocity::Measured VehicleWitness::measured(const NavigationEstimate& estimate,
                                            const Vector3d& gyro_bias) const {
  const double dt = elapsed_s_;
  velocity::Measured m;
  m.ned_to_body = estimate.body_to_ned.toRotationMatrix().transpose();
  m.earth_rate_ned = frame::earth_rate_ned(estimate.position.latitude_rad);
  Vector3d water = Vector3d::Zero();
  if (estimate.current) water.head<2>() = estimate.current->north_east_mps;
  const Vector3d over_ground = m.ned_to_body * estimate.velocity_ned;
  const Vector3d through_water = m.ned_to_body * (estimate.velocity_ned - water);
  const Vector3d earth_rate = m.ned_to_body * m.earth_rate_ned;
  m.velocity << through_water, rate_ - gyro_bias - earth_rate;
  const Vector3d turned = angle_ - dt * (gyro_bias + earth_rate);
  const Vector3d gravity =
      frame::gravity(estimate.position.latitude_rad, estimate.position.height_m) *
      (last_down_ + m.ned_to_body.col(2)) / 2;
  m.change << velocity_ + dt * (gravity - 2 * earth_rate.cross(over_ground)) -
                  turned.cross(through_water),
      rate_ - last_rate_;
  const Matrix3d variance =
      m.ned_to_body * estimate.covariance.block<3, 3>(3, 3) * m.ned_to_body.transpose();
  m.velocity_sigma = variance.diagonal().cwiseMax(0).cwiseSqrt();
  return m;
}

}  // namespace drydock::pipeline
