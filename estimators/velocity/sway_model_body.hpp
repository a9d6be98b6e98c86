#pragma once

#include "estimators/hydrodynamics/model_body.hpp"
#include "estimators/velocity/sway_model.hpp"

namespace drydock::velocity {

template <class Real>
BasicSwayModel<Real>::BasicSwayModel(const hydrodynamics::BasicVehicle<Real>& vehicle)
    : vehicle_(vehicle), mass_row_(hydrodynamics::mass_matrix(vehicle).row(1)) {}

template <class Real>
void BasicSwayModel<Real>::step(const BasicMotion<Real>& motion,
                                const hydrodynamics::Control& control, double dt) {
  const auto& c = vehicle_.coefficients;
  using Velocity = hydrodynamics::BasicVelocity<Real>;
  Velocity ahead = Velocity::Zero(), drifting, turning;
  ahead[0] = motion.u;
  drifting << motion.u, v_, motion.w, 0, 0, 0;
  turning << motion.u, v_, motion.w, motion.rate;
  const Real alone = hydrodynamics::hull_forces(c, ahead, control)[1];
  const Real with_drift = hydrodynamics::hull_forces(c, drifting, control)[1];
  const Real with_turn = hydrodynamics::hull_forces(c, turning, control)[1];
  const PerCause force{alone, with_drift - alone, with_turn - with_drift};

  // Eq. (V4). u-dot and w-dot have no influence, because this row of the mass matrix has zeros
  // there.
  const Real mass = mass_row_(1);
  const Real rigid =
      hydrodynamics::rigid_body_forces(vehicle_.body, turning, motion.earth_rate)[1] +
      (vehicle_.body.weight - vehicle_.body.buoyancy) * motion.down_y -
      mass_row_.template tail<3>().dot(motion.rate_change);
  const Real acceleration = (rigid + force.sum() + force.dot(factors_)) / mass;

  // Linearly implicit: the step contains half of its own change of the slope.
  const Real damping =
      (hydrodynamics::hull_force_partials(c, turning, control)(1, 1) +
       hydrodynamics::rigid_body_partials(vehicle_.body, turning, motion.earth_rate)(1, 1)) /
      mass;
  const Real by = dt / (1 - dt / 2 * damping);
  v_ += by * acceleration;
  sensitivity_ += by * (damping * sensitivity_ + force / mass);  // eq. (V5)
}

template <class Real>
void BasicSwayModel<Real>::correct(const PerCause& error) {
  factors_ -= error;
  v_ -= sensitivity_.dot(error);
}

}  // namespace drydock::velocity
