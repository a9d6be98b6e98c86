#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"

namespace drydock::velocity {

/// How the vehicle moves through the water, as inertial navigation knows it. Body axes.
struct Motion {
  double u = 0, w = 0;                                    ///< m/s
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();         ///< p q r, rad/s
  Eigen::Vector3d rate_change = Eigen::Vector3d::Zero();  ///< rad/s2
  Eigen::Vector3d earth_rate = Eigen::Vector3d::Zero();   ///< rad/s
  double down_y = 0;  ///< y of the direction "down": of weight and buoyancy
};

/// The sway equation alone: row Y of eq. (2), (3) for v, everything else given. The moment
/// equations are not needed, a gyro being better than any of them. Eq. (V4), (V5) of
/// docs/estimators/velocity.md.
class SwayModel {
 public:
  /// What the hull feels across, by cause: without drift and turn (asymmetry, rudder), from drift,
  /// from turning. Each may be wrong by a factor of its own, 1 + e.
  static constexpr int causes = 3;
  using PerCause = Eigen::Matrix<double, causes, 1>;

  explicit SwayModel(const hydrodynamics::Vehicle& vehicle);

  /// `dt` seconds on; stable for any dt.
  void step(const Motion& motion, const hydrodynamics::Control& control, double dt);

  double v() const { return v_; }
  /// dv/de: how v answers to the factors.
  const PerCause& sensitivity() const { return sensitivity_; }
  const PerCause& factor_errors() const { return factors_; }

  /// Takes an estimated error of the factors out, and with it what it has done to v.
  void correct(const PerCause& error);

 private:
  hydrodynamics::Vehicle vehicle_;
  Eigen::Matrix<double, 1, 6> mass_row_;
  double v_ = 0;
  PerCause sensitivity_ = PerCause::Zero(), factors_ = PerCause::Zero();
};

}  // namespace drydock::velocity
