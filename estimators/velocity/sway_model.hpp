#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"

namespace drydock::velocity {

/// The motion of the vehicle through the water from the inertial navigation. Body axes.
struct Motion {
  double u = 0, w = 0;                                    ///< m/s
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();         ///< p q r, rad/s
  Eigen::Vector3d rate_change = Eigen::Vector3d::Zero();  ///< rad/s2
  Eigen::Vector3d earth_rate = Eigen::Vector3d::Zero();   ///< rad/s
  double down_y = 0;  ///< y of the unit vector "down", for weight and buoyancy
};

/// Only the sway equation: row Y of eq. (2), (3) for v, with all other quantities given. The moment
/// equations are not needed, because the gyros are more accurate. Eq. (V4), (V5) of
/// docs/estimators/velocity.md.
class SwayModel {
 public:
  /// The sway force on the hull has three causes: the force without drift and turn (asymmetry,
  /// rudder), the drift and the turn. Each has its own error factor, 1 + e.
  static constexpr int causes = 3;
  using PerCause = Eigen::Matrix<double, causes, 1>;

  explicit SwayModel(const hydrodynamics::Vehicle& vehicle);

  /// Steps by `dt` seconds. Stable for any dt.
  void step(const Motion& motion, const hydrodynamics::Control& control, double dt);

  double v() const { return v_; }
  /// dv/de: the derivative of v by the errors of the factors.
  const PerCause& sensitivity() const { return sensitivity_; }
  const PerCause& factor_errors() const { return factors_; }

  /// Removes an estimated error of the factors, and its effect on v.
  void correct(const PerCause& error);

 private:
  hydrodynamics::Vehicle vehicle_;
  Eigen::Matrix<double, 1, 6> mass_row_;
  double v_ = 0;
  PerCause sensitivity_ = PerCause::Zero(), factors_ = PerCause::Zero();
};

}  // namespace drydock::velocity
