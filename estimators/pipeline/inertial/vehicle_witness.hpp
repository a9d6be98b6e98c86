#pragma once

#include <optional>

#include "estimators/pipeline/inertial/navigation_estimate.hpp"
#include "estimators/velocity/vehicle_watch.hpp"

namespace drydock::pipeline {

/// The vehicle's equations watch the IMU of an inertial navigation: "A vehicle that watches the
/// IMU" of docs/estimators/integrity.md. It changes no estimate.
class VehicleWitness {
 public:
  explicit VehicleWitness(const hydrodynamics::Vehicle& vehicle) : watch_(vehicle) {}

  /// Integrals of angular rate (rad) and specific force (m/s) over `dt`, at the vehicle's origin;
  /// `rate`: at its end, rad/s.
  void add_imu(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity,
               const Eigen::Vector3d& rate, double dt);
  /// The actuators' state.
  void control(const hydrodynamics::Control& control, Stamp valid_at);
  /// A step ended at this estimate.
  void step(const NavigationEstimate& estimate, const Eigen::Vector3d& gyro_bias);

  bool contradicts() const { return watch_.contradicts(); }

 private:
  velocity::Measured measured(const NavigationEstimate& estimate,
                              const Eigen::Vector3d& gyro_bias) const;

  velocity::VehicleWatch watch_;
  Eigen::Vector3d angle_ = Eigen::Vector3d::Zero(), velocity_ = angle_;  ///< since the last step
  Eigen::Vector3d rate_ = angle_, last_rate_ = angle_;
  Eigen::Vector3d last_down_ = angle_;  ///< in body axes, at the last step
  double elapsed_s_ = 0;
  hydrodynamics::Control control_;
  std::optional<Stamp> controlled_at_;
};

}  // namespace drydock::pipeline
