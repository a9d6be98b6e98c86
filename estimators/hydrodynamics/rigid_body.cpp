#include "estimators/hydrodynamics/rigid_body.hpp"

#include <Eigen/Geometry>

#include "estimators/frame/attitude.hpp"

namespace drydock::hydrodynamics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using frame::skew;

namespace {

/// D of eq. (2) times a vector: m r_G x a.
Vector3d d_bar(const RigidBody& body, const Vector3d& a) {
  const double m_z = body.mass * body.z_G;
  return {-m_z * a.y(), m_z * a.x(), 0};
}

/// z_G W - z_B B: the righting moment per sine of the tilt.
double righting(const RigidBody& body) { return body.z_G * body.weight - body.z_B * body.buoyancy; }

}  // namespace

Wrench rigid_body_forces(const RigidBody& body, const Velocity& velocity,
                         const Vector3d& earth_rate) {
  const Vector3d v = velocity.head<3>(), omega = velocity.tail<3>();
  const Vector3d d_omega = d_bar(body, omega);
  const Vector3d momentum = body.moments_of_inertia.cwiseProduct(omega);
  // Halves of a fixed size: the comma of Eigen takes both for blocks of any size.
  Wrench wrench;
  wrench.head<3>() = omega.cross(d_omega) - body.mass * (omega + 2 * earth_rate).cross(v);
  wrench.tail<3>() = momentum.cross(omega) + v.cross(d_omega) - omega.cross(d_bar(body, v));
  return wrench;
}

Matrix6 rigid_body_partials(const RigidBody& body, const Velocity& velocity,
                            const Vector3d& earth_rate) {
  const double m = body.mass, mz = m * body.z_G;
  const double u = velocity[0], v = velocity[1], w = velocity[2];
  const double p = velocity[3], q = velocity[4], r = velocity[5];
  const double yz = body.moments_of_inertia.y() - body.moments_of_inertia.z();
  const double zx = body.moments_of_inertia.z() - body.moments_of_inertia.x();
  const double xy = body.moments_of_inertia.x() - body.moments_of_inertia.y();
  const Vector3d turn = m * (velocity.tail<3>() + 2 * earth_rate);
  Matrix6 partials;
  partials << 0, turn.z(), -turn.y(), -mz * r, -m * w, m * v - mz * p,    //
      -turn.z(), 0, turn.x(), m * w, -mz * r, -m * u - mz * q,            //
      turn.y(), -turn.x(), 0, 2 * mz * p - m * v, 2 * mz * q + m * u, 0,  //
      mz * r, 0, -mz * p, -mz * w, yz * r, yz * q + mz * u,               //
      0, mz * r, -mz * q, zx * r, -mz * w, zx * p + mz * v,               //
      0, 0, 0, xy * q, xy * p, 0;
  return partials;
}

Eigen::Matrix<double, 6, 3> rigid_body_attitude_partials(const RigidBody& body,
                                                         const Velocity& velocity,
                                                         const Vector3d& earth_rate) {
  Eigen::Matrix<double, 6, 3> partials;
  partials << 2 * body.mass * skew(velocity.head<3>()) * skew(earth_rate), Matrix3d::Zero();
  return partials;
}

Wrench hydrostatic_forces(const RigidBody& body, const Vector3d& down) {
  Wrench wrench;
  wrench.head<3>() = (body.weight - body.buoyancy) * down;
  wrench.tail<3>() = righting(body) * Vector3d{-down.y(), down.x(), 0};
  return wrench;
}

Eigen::Matrix<double, 6, 3> hydrostatic_attitude_partials(const RigidBody& body,
                                                          const Vector3d& down) {
  Eigen::Matrix<double, 6, 3> partials;
  partials << (body.weight - body.buoyancy) * skew(down),
      righting(body) * skew(Vector3d::UnitZ()) * skew(down);
  return partials;
}

}  // namespace drydock::hydrodynamics
