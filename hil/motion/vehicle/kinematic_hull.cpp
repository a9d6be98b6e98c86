#include "hil/motion/vehicle/kinematic_hull.hpp"

#include <cmath>

#include "hil/motion/vehicle/actuator_law.hpp"

namespace drydock::motion {

hydrodynamics::Velocity kinematic_acceleration(const hydrodynamics::Velocity& velocity,
                                               const Eigen::Matrix3d& ned_to_body,
                                               const hydrodynamics::Control& control) {
  constexpr double lag_s = 0.5, righting_s = 2;
  const double u = velocity[0];
  const double roll = std::atan2(ned_to_body(1, 2), ned_to_body(2, 2));
  hydrodynamics::Velocity wanted = hydrodynamics::Velocity::Zero();
  wanted[0] = control.u_c;
  wanted[3] = -roll / righting_s;
  wanted[4] = -u * (control.delta_s - control.delta_b) / (2 * rudder_per_curvature_m);
  wanted[5] = -u * control.delta_r / rudder_per_curvature_m;
  return (wanted - velocity) / lag_s;
}

}  // namespace drydock::motion
