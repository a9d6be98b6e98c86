#pragma once

#include <Eigen/Geometry>

#include "estimators/frame/skew.hpp"
#include "estimators/hydrodynamics/rigid_body.hpp"

namespace drydock::hydrodynamics {

/// D of eq. (2) times a vector: m r_G x a.
template <class Real>
Eigen::Vector3<Real> d_bar(const BasicRigidBody<Real>& body,
                           const std::type_identity_t<Eigen::Vector3<Real>>& a) {
  const Real m_z = body.mass * body.z_G;
  return {-m_z * a.y(), m_z * a.x(), 0};
}

/// z_G W - z_B B: the righting moment per sine of the tilt.
template <class Real>
Real righting(const BasicRigidBody<Real>& body) {
  return body.z_G * body.weight - body.z_B * body.buoyancy;
}

template <class Real>
BasicWrench<Real> rigid_body_forces(const BasicRigidBody<Real>& body,
                                    const BasicVelocity<Real>& velocity,
                                    const std::type_identity_t<Eigen::Vector3<Real>>& earth_rate) {
  const Eigen::Vector3<Real> v = velocity.template head<3>(), omega = velocity.template tail<3>();
  const Eigen::Vector3<Real> d_omega = d_bar(body, omega);
  const Eigen::Vector3<Real> momentum = body.moments_of_inertia.cwiseProduct(omega);
  // Halves of a fixed size: the comma of Eigen takes both for blocks of any size.
  BasicWrench<Real> wrench;
  wrench.template head<3>() = omega.cross(d_omega) - body.mass * (omega + 2 * earth_rate).cross(v);
  wrench.template tail<3>() =
      momentum.cross(omega) + v.cross(d_omega) - omega.cross(d_bar(body, v));
  return wrench;
}

template <class Real>
BasicMatrix6<Real> rigid_body_partials(
    const BasicRigidBody<Real>& body, const BasicVelocity<Real>& velocity,
    const std::type_identity_t<Eigen::Vector3<Real>>& earth_rate) {
  const Real m = body.mass, mz = m * body.z_G;
  const Real u = velocity[0], v = velocity[1], w = velocity[2];
  const Real p = velocity[3], q = velocity[4], r = velocity[5];
  const Real yz = body.moments_of_inertia.y() - body.moments_of_inertia.z();
  const Real zx = body.moments_of_inertia.z() - body.moments_of_inertia.x();
  const Real xy = body.moments_of_inertia.x() - body.moments_of_inertia.y();
  const Eigen::Vector3<Real> turn = m * (velocity.template tail<3>() + 2 * earth_rate);
  BasicMatrix6<Real> partials;
  partials << 0, turn.z(), -turn.y(), -mz * r, -m * w, m * v - mz * p,    //
      -turn.z(), 0, turn.x(), m * w, -mz * r, -m * u - mz * q,            //
      turn.y(), -turn.x(), 0, 2 * mz * p - m * v, 2 * mz * q + m * u, 0,  //
      mz * r, 0, -mz * p, -mz * w, yz * r, yz * q + mz * u,               //
      0, mz * r, -mz * q, zx * r, -mz * w, zx * p + mz * v,               //
      0, 0, 0, xy * q, xy * p, 0;
  return partials;
}

template <class Real>
Eigen::Matrix<Real, 6, 3> rigid_body_attitude_partials(
    const BasicRigidBody<Real>& body, const BasicVelocity<Real>& velocity,
    const std::type_identity_t<Eigen::Vector3<Real>>& earth_rate) {
  Eigen::Matrix<Real, 6, 3> partials;
  partials << 2 * body.mass * frame::skew<Real>(velocity.template head<3>()) *
                  frame::skew<Real>(earth_rate),
      Eigen::Matrix3<Real>::Zero();
  return partials;
}

template <class Real>
BasicWrench<Real> hydrostatic_forces(const BasicRigidBody<Real>& body,
                                     const std::type_identity_t<Eigen::Vector3<Real>>& down) {
  BasicWrench<Real> wrench;
  wrench.template head<3>() = (body.weight - body.buoyancy) * down;
  wrench.template tail<3>() = righting(body) * Eigen::Vector3<Real>{-down.y(), down.x(), 0};
  return wrench;
}

template <class Real>
Eigen::Matrix<Real, 6, 3> hydrostatic_attitude_partials(
    const BasicRigidBody<Real>& body, const std::type_identity_t<Eigen::Vector3<Real>>& down) {
  Eigen::Matrix<Real, 6, 3> partials;
  partials << (body.weight - body.buoyancy) * frame::skew<Real>(down),
      righting(body) * frame::skew<Real>(Eigen::Vector3<Real>::UnitZ()) * frame::skew<Real>(down);
  return partials;
}

}  // namespace drydock::hydrodynamics
