#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"

/// What the water does to hull, surfaces and propeller: eq. (3) without added mass and weight.
namespace drydock::hydrodynamics {

/// [F^s + F^c + F^d; M^s + M^c + M^d], `velocity` being that through the water.
Wrench hull_forces(const Coefficients& c, const Velocity& velocity, const Control& control);

/// Its derivative by u v w p q r, the paper's appendix put right: eq. (A5). Where a force has a
/// kink (v, w, p, q or r = 0) it is the mean of both sides.
Matrix6 hull_force_partials(const Coefficients& c, const Velocity& velocity,
                            const Control& control);

/// v_h = sqrt(v^2 + w^2 + (1e-8 m/s)^2): the guard keeps 1/v_h finite where there is no cross-flow.
double cross_flow_speed(double v, double w);

/// s_x of the equations: -1, 0 or 1.
inline double sign(double x) { return (x > 0) - (x < 0); }

}  // namespace drydock::hydrodynamics
