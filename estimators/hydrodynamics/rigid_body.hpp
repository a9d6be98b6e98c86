#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"

/// The terms of the rigid body in eq. (2). `earth_rate` is the rotation of the Earth in body axes,
/// rad/s.
namespace drydock::hydrodynamics {

/// [f_RB; h_RB]
Wrench rigid_body_forces(const RigidBody& body, const Velocity& velocity,
                         const Eigen::Vector3d& earth_rate);

/// Derivative of rigid_body_forces() by u v w p q r, eq. (A1)-(A4).
Matrix6 rigid_body_partials(const RigidBody& body, const Velocity& velocity,
                            const Eigen::Vector3d& earth_rate);

/// Derivative of rigid_body_forces() by a small rotation sigma of the body about its own axes:
/// C_n^b <- (I - sigma x) C_n^b.
Eigen::Matrix<double, 6, 3> rigid_body_attitude_partials(const RigidBody& body,
                                                         const Velocity& velocity,
                                                         const Eigen::Vector3d& earth_rate);

/// Weight and buoyancy, [F^b; M^b] of eq. (3). `down`: unit vector, third column of C_n^b.
Wrench hydrostatic_forces(const RigidBody& body, const Eigen::Vector3d& down);

/// Derivative of hydrostatic_forces() by the same small rotation.
Eigen::Matrix<double, 6, 3> hydrostatic_attitude_partials(const RigidBody& body,
                                                          const Eigen::Vector3d& down);

}  // namespace drydock::hydrodynamics
