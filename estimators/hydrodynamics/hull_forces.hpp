#pragma once

#include <type_traits>

#include "estimators/hydrodynamics/vehicle.hpp"
#include "estimators/lanes/real.hpp"

/// Forces of the water on hull, surfaces and propeller: eq. (3) without added mass and weight.
namespace drydock::hydrodynamics {

/// [F^s + F^c + F^d; M^s + M^c + M^d]. `velocity` is the velocity through the water.
template <class Real>
BasicWrench<Real> hull_forces(const BasicCoefficients<Real>& c,
                              const std::type_identity_t<BasicVelocity<Real>>& velocity,
                              const Control& control);

/// Derivative of hull_forces() by u v w p q r: eq. (A5), the paper's appendix with corrections.
/// Where a force has a kink (v, w, p, q or r = 0), it is the mean of both sides.
template <class Real>
BasicMatrix6<Real> hull_force_partials(const BasicCoefficients<Real>& c,
                                       const std::type_identity_t<BasicVelocity<Real>>& velocity,
                                       const Control& control);

/// v_h = sqrt(v^2 + w^2 + (1e-8 m/s)^2). The last term keeps 1/v_h finite without cross-flow.
template <class Real>
requires(!std::is_integral_v<Real>) Real cross_flow_speed(const Real& v, const Real& w) {
  using lanes::sqrt;
  constexpr double guard = 1e-16;
  return sqrt(v * v + w * w + guard);
}
inline double cross_flow_speed(double v, double w) { return cross_flow_speed<double>(v, w); }

/// s_x of the equations: -1, 0 or 1.
template <class Real>
Real sign(const Real& x) {
  using lanes::select;
  return select(x > 0, 1.0, select(x < 0, -1.0, 0.0));
}

}  // namespace drydock::hydrodynamics
