#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"

/// Forces of the water on hull, surfaces and propeller: eq. (3) without added mass and weight.
namespace drydock::hydrodynamics {

/// [F^s + F^c + F^d; M^s + M^c + M^d]. `velocity` is the velocity through the water.
Wrench hull_forces(const Coefficients& c, const Velocity& velocity, const Control& control);

/// Derivative of hull_forces() by u v w p q r: eq. (A5), the paper's appendix with corrections.
/// Where a force has a kink (v, w, p, q or r = 0), it is the mean of both sides.
Matrix6 hull_force_partials(const Coefficients& c, const Velocity& velocity,
                            const Control& control);

/// v_h = sqrt(v^2 + w^2 + (1e-8 m/s)^2). The last term keeps 1/v_h finite without cross-flow.
double cross_flow_speed(double v, double w);

/// s_x of the equations: -1, 0 or 1.
inline double sign(double x) { return (x > 0) - (x < 0); }

}  // namespace drydock::hydrodynamics
