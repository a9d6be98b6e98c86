#pragma once

#include <type_traits>

#include "estimators/hydrodynamics/vehicle.hpp"

/// The terms of the rigid body in eq. (2). `earth_rate` is the rotation of the Earth in body axes,
/// rad/s.
namespace drydock::hydrodynamics {

/// [f_RB; h_RB]
template <class Real>
BasicWrench<Real> rigid_body_forces(const BasicRigidBody<Real>& body,
                                    const BasicVelocity<Real>& velocity,
                                    const std::type_identity_t<Eigen::Vector3<Real>>& earth_rate);

/// Derivative of rigid_body_forces() by u v w p q r, eq. (A1)-(A4).
template <class Real>
BasicMatrix6<Real> rigid_body_partials(
    const BasicRigidBody<Real>& body, const BasicVelocity<Real>& velocity,
    const std::type_identity_t<Eigen::Vector3<Real>>& earth_rate);

/// Derivative of rigid_body_forces() by a small rotation sigma of the body about its own axes:
/// C_n^b <- (I - sigma x) C_n^b.
template <class Real>
Eigen::Matrix<Real, 6, 3> rigid_body_attitude_partials(
    const BasicRigidBody<Real>& body, const BasicVelocity<Real>& velocity,
    const std::type_identity_t<Eigen::Vector3<Real>>& earth_rate);

/// Weight and buoyancy, [F^b; M^b] of eq. (3). `down`: unit vector, third column of C_n^b.
template <class Real>
BasicWrench<Real> hydrostatic_forces(const BasicRigidBody<Real>& body,
                                     const std::type_identity_t<Eigen::Vector3<Real>>& down);

/// Derivative of hydrostatic_forces() by the same small rotation.
template <class Real>
Eigen::Matrix<Real, 6, 3> hydrostatic_attitude_partials(
    const BasicRigidBody<Real>& body, const std::type_identity_t<Eigen::Vector3<Real>>& down);

}  // namespace drydock::hydrodynamics
