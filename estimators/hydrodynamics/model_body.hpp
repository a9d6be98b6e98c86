#pragma once

#include "estimators/hydrodynamics/hull_force_partials_body.hpp"
#include "estimators/hydrodynamics/hull_forces_body.hpp"
#include "estimators/hydrodynamics/model.hpp"
#include "estimators/hydrodynamics/rigid_body_body.hpp"

namespace drydock::hydrodynamics {

/// [M_A E_A; D_A J_A] of eq. (3): derivative of F^a and M^a by the accelerations.
template <class Real>
BasicMatrix6<Real> added_mass(const BasicCoefficients<Real>& c) {
  BasicMatrix6<Real> a;
  a << c.X_udot, 0, 0, 0, 0, 0,               //
      0, c.Y_vdot, 0, c.Y_pdot, 0, c.Y_rdot,  //
      0, 0, c.Z_wdot, 0, c.Z_qdot, 0,         //
      0, c.K_vdot, 0, c.K_pdot, 0, c.K_rdot,  //
      0, 0, c.M_wdot, 0, c.M_qdot, 0,         //
      0, c.N_vdot, 0, c.N_pdot, 0, c.N_rdot;
  return a;
}

template <class Real>
BasicMatrix6<Real> mass_matrix(const BasicVehicle<Real>& vehicle) {
  using Vector3 = Eigen::Vector3<Real>;
  using Matrix3 = Eigen::Matrix3<Real>;
  const BasicRigidBody<Real>& body = vehicle.body;
  const Matrix3 d = body.mass * body.z_G * frame::skew<Real>(Vector3::UnitZ());
  BasicMatrix6<Real> rigid;
  rigid << body.mass * Matrix3::Identity(), -d,  //
      d, Matrix3{body.moments_of_inertia.asDiagonal()};
  return rigid - added_mass(vehicle.coefficients);
}

template <class Real>
template <int Columns>
Eigen::Matrix<Real, 6, Columns> BasicModel<Real>::accelerations(
    const Eigen::Matrix<Real, 6, Columns>& wrenches) const {
  Eigen::Matrix<Real, 6, Columns> all;
  for (int column = 0; column < Columns; ++column) {
    const auto by_pair = [&](int pair) { return wrenches.col(column).template segment<2>(pair); };
    for (int row = 0; row < 6; row += 2) {
      const auto mobility = [&](int pair) {
        return Eigen::Vector2<Real>{inverse_mass_(row, pair), inverse_mass_(row + 1, pair + 1)};
      };
      all.col(column).template segment<2>(row) = mobility(0).cwiseProduct(by_pair(0)) +
                                                 mobility(2).cwiseProduct(by_pair(2)) +
                                                 mobility(4).cwiseProduct(by_pair(4));
    }
  }
  return all;
}

template <class Real>
BasicVelocity<Real> BasicModel<Real>::acceleration(const BasicVelocity<Real>& velocity,
                                                   const Matrix3& ned_to_body,
                                                   const Control& control,
                                                   const Vector3& earth_rate_ned) const {
  return accelerations<1>(
      rigid_body_forces<Real>(vehicle_.body, velocity, ned_to_body * earth_rate_ned) +
      hull_forces(vehicle_.coefficients, velocity, control) +
      hydrostatic_forces<Real>(vehicle_.body, ned_to_body.col(2)));
}

template <class Real>
BasicMatrix6<Real> BasicModel<Real>::velocity_partials(const BasicVelocity<Real>& velocity,
                                                       const Matrix3& ned_to_body,
                                                       const Control& control,
                                                       const Vector3& earth_rate_ned) const {
  return accelerations<6>(
      rigid_body_partials<Real>(vehicle_.body, velocity, ned_to_body * earth_rate_ned) +
      hull_force_partials(vehicle_.coefficients, velocity, control));
}

}  // namespace drydock::hydrodynamics
