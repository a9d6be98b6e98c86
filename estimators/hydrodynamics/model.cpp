#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <stdexcept>

#include "estimators/frame/attitude.hpp"
#include "estimators/hydrodynamics/model_body.hpp"

namespace drydock::hydrodynamics {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

Matrix6 checked_inverse(const Vehicle& vehicle) {
  const Matrix6 mass = mass_matrix(vehicle);
  if (!is_mass(mass))
    throw std::invalid_argument(
        "the vehicle's mass and added mass give some motion a negative kinetic energy");
  return mass.inverse();
}

}  // namespace

bool is_mass(const Matrix6& mass_matrix) {
  const Matrix6 symmetric = (mass_matrix + mass_matrix.transpose()) / 2;
  return symmetric.allFinite() && Eigen::LLT<Matrix6>{symmetric}.info() == Eigen::Success;
}

template <>
Model::BasicModel(const Vehicle& vehicle)
    : vehicle_(vehicle), inverse_mass_(checked_inverse(vehicle)) {}

template <>
Partials Model::partials(const Velocity& velocity, const Matrix3d& ned_to_body,
                         const Control& control, const Vector3d& earth_rate_ned) const {
  const RigidBody& body = vehicle_.body;
  return {
      velocity_partials(velocity, ned_to_body, control, earth_rate_ned),
      accelerations<3>(rigid_body_attitude_partials(body, velocity, ned_to_body * earth_rate_ned) +
                       hydrostatic_attitude_partials(body, ned_to_body.col(2)))};
}

template <>
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

template <>
State Model::step(const State& state, const Control& control, double dt,
                  const Surroundings& surroundings) const {
  const State k1 = derivative(state, control, surroundings);
  const State k2 = derivative(state + dt / 2 * k1, control, surroundings);
  const State k3 = derivative(state + dt / 2 * k2, control, surroundings);
  const State k4 = derivative(state + dt * k3, control, surroundings);
  return state + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

template Matrix6 mass_matrix(const Vehicle&);
template class BasicModel<double>;

}  // namespace drydock::hydrodynamics
