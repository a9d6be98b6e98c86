#include "estimators/velocity/sway_model.hpp"

#include "estimators/hydrodynamics/hull_forces.hpp"
#include "estimators/hydrodynamics/model.hpp"
#include "estimators/hydrodynamics/rigid_body.hpp"

namespace drydock::velocity {

using hydrodynamics::Velocity;

SwayModel::SwayModel(const hydrodynamics::Vehicle& vehicle)
    : vehicle_(vehicle), mass_row_(hydrodynamics::mass_matrix(vehicle).row(1)) {}

void SwayModel::step(const Motion& motion, const hydrodynamics::Control& control, double dt) {
  const auto& c = vehicle_.coefficients;
  Velocity ahead = Velocity::Zero(), drifting, turning;
  ahead[0] = motion.u;
  drifting << motion.u, v_, motion.w, 0, 0, 0;
  turning << motion.u, v_, motion.w, motion.rate;
  const double alone = hydrodynamics::hull_forces(c, ahead, control)[1];
  const double with_drift = hydrodynamics::hull_forces(c, drifting, control)[1];
  const double with_turn = hydrodynamics::hull_forces(c, turning, control)[1];
  const PerCause force{alone, with_drift - alone, with_turn - with_drift};

  // Eq. (V4). u-dot and w-dot have no influence, because this row of the mass matrix has zeros
  // there.
  const double mass = mass_row_(1);
  const double rigid =
      hydrodynamics::rigid_body_forces(vehicle_.body, turning, motion.earth_rate)[1] +
      (vehicle_.body.weight - vehicle_.body.buoyancy) * motion.down_y -
      mass_row_.tail<3>().dot(motion.rate_change);
  const double acceleration = (rigid + force.sum() + force.dot(factors_)) / mass;

  // Linearly implicit: the step contains half of its own change of the slope.
  const double damping =
      (hydrodynamics::hull_force_partials(c, turning, control)(1, 1) +
       hydrodynamics::rigid_body_partials(vehicle_.body, turning, motion.earth_rate)(1, 1)) /
      mass;
  const double by = dt / (1 - dt / 2 * damping);
  v_ += by * acceleration;
  sensitivity_ += by * (damping * sensitivity_ + force / mass);  // eq. (V5)
}

void SwayModel::correct(const PerCause& error) {
  factors_ -= error;
  v_ -= sensitivity_.dot(error);
}

}  // namespace drydock::velocity
