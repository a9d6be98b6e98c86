#pragma once

#include "estimators/hydrodynamics/model.hpp"

namespace drydock::velocity {

/// The motion of a vehicle over a step as its inertial navigation has it, in body axes.
struct Measured {
  hydrodynamics::Velocity velocity;  ///< through the water and against NED, at the end
  hydrodynamics::Velocity change;    ///< of it over the step, by gyros and accelerometers
  Eigen::Vector3d velocity_sigma;    ///< of its first three values, m/s
  Eigen::Matrix3d ned_to_body;       ///< C_n^b
  Eigen::Vector3d earth_rate_ned;    ///< rad/s
};

/// Compares the accelerations that an IMU measures with those of the vehicle's equations: (V10) to
/// (V12) of docs/estimators/velocity.md. A gyro that drifts turns nothing else, so it shows before
/// any velocity is wrong. Allocates nothing after its construction.
class VehicleWatch {
 public:
  /// Of a standard normal value, two-sided 7e-6.
  static constexpr double limit = 4.5;

  /// Throws std::invalid_argument (one line) for a vehicle with an invalid mass matrix.
  explicit VehicleWatch(const hydrodynamics::Vehicle& vehicle) : model_(vehicle) {}

  /// One step of `dt` seconds.
  void add(const Measured& measured, const hydrodynamics::Control& control, double dt);
  /// Begins anew, because of a gap.
  void clear() {
    sums_ = {};
    before_ = {};
  }

  /// Each component over its standard deviation.
  hydrodynamics::Velocity statistic() const;
  bool contradicts() const {
    return !(statistic().cwiseAbs().maxCoeff() <= limit);  // true for NaN too
  }

 private:
  using Causes = Eigen::Matrix<double, 6, 3>;
  struct Accelerations {
    hydrodynamics::Velocity all = hydrodynamics::Velocity::Zero();
    Causes by_cause = Causes::Zero();
    hydrodynamics::Velocity by_velocity = hydrodynamics::Velocity::Zero();  ///< of its sigma
  };
  /// Of the last seconds, the latest counted most.
  struct Sums {
    hydrodynamics::Velocity unexplained = hydrodynamics::Velocity::Zero();
    Causes by_cause = Causes::Zero();
    hydrodynamics::Velocity by_velocity = hydrodynamics::Velocity::Zero();
    hydrodynamics::Velocity by_time = hydrodynamics::Velocity::Zero();
  };
  Accelerations accelerations(const Measured& measured,
                              const hydrodynamics::Control& control) const;

  hydrodynamics::Model model_;
  Sums sums_;
  struct Before {
    bool known = false;
    Accelerations at;
  } before_;
};

}  // namespace drydock::velocity
