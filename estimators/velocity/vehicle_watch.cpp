#include "estimators/velocity/vehicle_watch.hpp"

#include <cmath>

#include "estimators/hydrodynamics/hull_forces.hpp"

namespace drydock::velocity {

using hydrodynamics::Velocity;

namespace {

/// The accelerations of so many seconds count.
constexpr double span_s = 2;

/// Share of its force by which each cause may be wrong: .2 for drift and turn as in the filter; a
/// little more for rudder, planes and propeller, so that one that is wholly wrong contradicts no
/// IMU: 1 / .25 is below the limit.
const Eigen::Array3d force_share{0.25, 0.2, 0.2};

/// One sigma of what is not known of the time of an actuator's state.
constexpr double late_s = 0.1;

/// One sigma of a vehicle's own restlessness in still water, m/s and rad/s. Chosen.
constexpr double restless_mps = 0.003, restless_radps = 1e-4;

}  // namespace

VehicleWatch::Accelerations VehicleWatch::accelerations(
    const Measured& m, const hydrodynamics::Control& control) const {
  const auto& hull = model_.vehicle().coefficients;
  const auto forces = [&](const Velocity& velocity) -> hydrodynamics::Wrench {
    return hydrodynamics::hull_forces(hull, velocity, control);
  };
  Velocity ahead = Velocity::Zero(), drifting = Velocity::Zero(), off = m.velocity;
  ahead(0) = m.velocity(0);
  drifting.head<3>() = m.velocity.head<3>();
  off.head<3>() += m.velocity_sigma;
  Eigen::Matrix<double, 6, 4> force;
  force.col(0) = forces(ahead);
  force.col(1) = forces(drifting) - force.col(0);
  force.col(2) = forces(m.velocity) - force.col(0) - force.col(1);
  force.col(3) = forces(off) - force.leftCols<3>().rowwise().sum();
  const Eigen::Matrix<double, 6, 4> by = model_.inverse_mass() * force;
  return {model_.acceleration(m.velocity, m.ned_to_body, control, m.earth_rate_ned),
          by.leftCols<3>(), by.col(3)};
}

void VehicleWatch::add(const Measured& measured, const hydrodynamics::Control& control, double dt) {
  const Accelerations now = accelerations(measured, control);
  if (before_.known) {
    const double kept = std::exp(-dt / span_s);
    const Accelerations& then = before_.at;
    sums_.unexplained = kept * sums_.unexplained + measured.change - dt / 2 * (now.all + then.all);
    sums_.by_cause = kept * sums_.by_cause + dt * now.by_cause;
    sums_.by_velocity = kept * sums_.by_velocity + dt * now.by_velocity;
    sums_.by_time =
        kept * sums_.by_time + late_s * (now.by_cause.col(0) - then.by_cause.col(0)).cwiseAbs();
  }
  before_ = {true, now};
}

Velocity VehicleWatch::statistic() const {
  Velocity restless;
  restless << Eigen::Vector3d::Constant(restless_mps), Eigen::Vector3d::Constant(restless_radps);
  const Velocity variance = restless.cwiseAbs2() + sums_.by_velocity.cwiseAbs2() +
                            sums_.by_time.cwiseAbs2() +
                            sums_.by_cause.cwiseAbs2() * force_share.square().matrix();
  return sums_.unexplained.cwiseQuotient(variance.cwiseSqrt());
}

}  // namespace drydock::velocity
