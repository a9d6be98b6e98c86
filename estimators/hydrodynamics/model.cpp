#include "estimators/hydrodynamics/model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <stdexcept>

#include "estimators/frame/attitude.hpp"
#include "estimators/hydrodynamics/hull_forces.hpp"
#include "estimators/hydrodynamics/rigid_body.hpp"

namespace drydock::hydrodynamics {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// [M_A E_A; D_A J_A] of eq. (3): derivative of F^a and M^a by the accelerations.
Matrix6 added_mass(const Coefficients& c) {
  Matrix6 a;
  a << c.X_udot, 0, 0, 0, 0, 0,               //
      0, c.Y_vdot, 0, c.Y_pdot, 0, c.Y_rdot,  //
      0, 0, c.Z_wdot, 0, c.Z_qdot, 0,         //
      0, c.K_vdot, 0, c.K_pdot, 0, c.K_rdot,  //
      0, 0, c.M_wdot, 0, c.M_qdot, 0,         //
      0, c.N_vdot, 0, c.N_pdot, 0, c.N_rdot;
  return a;
}

Matrix6 checked_inverse(const Vehicle& vehicle) {
  const Matrix6 mass = mass_matrix(vehicle);
  if (!is_mass(mass))
    throw std::invalid_argument(
        "the vehicle's mass and added mass give some motion a negative kinetic energy");
  return mass.inverse();
}

}  // namespace

Matrix6 mass_matrix(const Vehicle& vehicle) {
  const RigidBody& body = vehicle.body;
  const Matrix3d d = body.mass * body.z_G * frame::skew(Vector3d::UnitZ());
  Matrix6 rigid;
  rigid << body.mass * Matrix3d::Identity(), -d,  //
      d, Matrix3d{body.moments_of_inertia.asDiagonal()};
  return rigid - added_mass(vehicle.coefficients);
}

bool is_mass(const Matrix6& mass_matrix) {
  const Matrix6 symmetric = (mass_matrix + mass_matrix.transpose()) / 2;
  return symmetric.allFinite() && Eigen::LLT<Matrix6>{symmetric}.info() == Eigen::Success;
}

Model::Model(const Vehicle& vehicle) : vehicle_(vehicle), inverse_mass_(checked_inverse(vehicle)) {}

template <int Columns>
Eigen::Matrix<double, 6, Columns> Model::accelerations(
    const Eigen::Matrix<double, 6, Columns>& wrenches) const {
  Eigen::Matrix<double, 6, Columns> all;
  for (int column = 0; column < Columns; ++column) {
    const auto by_pair = [&](int pair) { return wrenches.col(column).template segment<2>(pair); };
    for (int row = 0; row < 6; row += 2) {
      const auto mobility = [&](int pair) {
        return Eigen::Vector2d{inverse_mass_(row, pair), inverse_mass_(row + 1, pair + 1)};
      };
      all.col(column).template segment<2>(row) = mobility(0).cwiseProduct(by_pair(0)) +
                                                 mobility(2).cwiseProduct(by_pair(2)) +
                                                 mobility(4).cwiseProduct(by_pair(4));
    }
  }
  return all;
}

Velocity Model::acceleration(const Velocity& velocity, const Matrix3d& ned_to_body,
                             const Control& control, const Vector3d& earth_rate_ned) const {
  return accelerations<1>(rigid_body_forces(vehicle_.body, velocity, ned_to_body * earth_rate_ned) +
                          hull_forces(vehicle_.coefficients, velocity, control) +
                          hydrostatic_forces(vehicle_.body, ned_to_body.col(2)));
}

Matrix6 Model::velocity_partials(const Velocity& velocity, const Matrix3d& ned_to_body,
                                 const Control& control, const Vector3d& earth_rate_ned) const {
  return accelerations<6>(
      rigid_body_partials(vehicle_.body, velocity, ned_to_body * earth_rate_ned) +
      hull_force_partials(vehicle_.coefficients, velocity, control));
}

Partials Model::partials(const Velocity& velocity, const Matrix3d& ned_to_body,
                         const Control& control, const Vector3d& earth_rate_ned) const {
  const RigidBody& body = vehicle_.body;
  return {
      velocity_partials(velocity, ned_to_body, control, earth_rate_ned),
      accelerations<3>(rigid_body_attitude_partials(body, velocity, ned_to_body * earth_rate_ned) +
                       hydrostatic_attitude_partials(body, ned_to_body.col(2)))};
}

State Model::derivative(const State& state, const Control& control,
                        const Surroundings& surroundings) const {
  const Velocity velocity = state.head<6>();
  const frame::Euler attitude{state[9], state[10], state[11]};
  const Matrix3d ned_to_body = frame::ned_to_body(attitude);
  State rate;
  rate << acceleration(velocity, ned_to_body, control, surroundings.earth_rate),
      ned_to_body.transpose() * velocity.head<3>() + surroundings.current,
      frame::euler_rates(attitude, velocity.tail<3>());
  return rate;
}

State Model::step(const State& state, const Control& control, double dt,
                  const Surroundings& surroundings) const {
  const State k1 = derivative(state, control, surroundings);
  const State k2 = derivative(state + dt / 2 * k1, control, surroundings);
  const State k3 = derivative(state + dt / 2 * k2, control, surroundings);
  const State k4 = derivative(state + dt * k3, control, surroundings);
  return state + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

}  // namespace drydock::hydrodynamics
