#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"

namespace drydock::velocity {

/// The motion of the vehicle through the water from the inertial navigation. Body axes.
template <class Real>
struct BasicMotion {
  Real u = 0, w = 0;                                                ///< m/s
  Eigen::Vector3<Real> rate = Eigen::Vector3<Real>::Zero();         ///< p q r, rad/s
  Eigen::Vector3<Real> rate_change = Eigen::Vector3<Real>::Zero();  ///< rad/s2
  Eigen::Vector3<Real> earth_rate = Eigen::Vector3<Real>::Zero();   ///< rad/s
  Real down_y = 0;  ///< y of the unit vector "down", for weight and buoyancy
};
using Motion = BasicMotion<double>;

/// Only the sway equation: row Y of eq. (2), (3) for v, with all other quantities given. The moment
/// equations are not needed, because the gyros are more accurate. Eq. (V4), (V5) of
/// docs/estimators/velocity.md.
template <class Real>
class BasicSwayModel {
 public:
  /// The sway force on the hull has three causes: the force without drift and turn (asymmetry,
  /// rudder), the drift and the turn. Each has its own error factor, 1 + e.
  static constexpr int causes = 3;
  using PerCause = Eigen::Matrix<Real, causes, 1>;

  explicit BasicSwayModel(const hydrodynamics::BasicVehicle<Real>& vehicle);

  /// Steps by `dt` seconds. Stable for any dt.
  void step(const BasicMotion<Real>& motion, const hydrodynamics::Control& control, double dt);

  Real v() const { return v_; }
  /// dv/de: the derivative of v by the errors of the factors.
  const PerCause& sensitivity() const { return sensitivity_; }
  const PerCause& factor_errors() const { return factors_; }

  /// Removes an estimated error of the factors, and its effect on v.
  void correct(const PerCause& error);

 private:
  hydrodynamics::BasicVehicle<Real> vehicle_;
  Eigen::Matrix<Real, 1, 6> mass_row_;
  Real v_ = 0;
  PerCause sensitivity_ = PerCause::Zero(), factors_ = PerCause::Zero();
};
using SwayModel = BasicSwayModel<double>;

}  // namespace drydock::velocity
