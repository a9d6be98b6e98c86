#pragma once

#include <Eigen/Core>

#include "estimators/hydrodynamics/vehicle.hpp"

namespace drydock::motion {

/// The law of actuator_law.hpp the other way round: a vehicle without mass, whose speed, pitch rate
/// and rate of turn go to what its propeller, planes and rudder say with a lag of 0.5 s. It has no
/// side slip, and rights itself.
hydrodynamics::Velocity kinematic_acceleration(const hydrodynamics::Velocity& velocity,
                                               const Eigen::Matrix3d& ned_to_body,
                                               const hydrodynamics::Control& control);

}  // namespace drydock::motion
