#pragma once

#include <Eigen/Core>

#include "estimators/hydrodynamics/coefficients.hpp"

namespace drydock::hydrodynamics {

/// Mass properties about the origin of the body axes. The coefficients hold in the same axes. Both
/// centres lie on the z axis: r_G = [0 0 z_G], r_B = [0 0 z_B]. SI.
template <class Real>
struct BasicRigidBody {
  Real mass = 0;
  Real weight = 0, buoyancy = 0;  ///< W, B; N
  Real z_G = 0, z_B = 0;          ///< positive below the origin
  Eigen::Vector3<Real> moments_of_inertia{Eigen::Vector3<Real>::Zero()};  ///< I_x I_y I_z
};
using RigidBody = BasicRigidBody<double>;

template <class Real>
struct BasicVehicle {
  BasicRigidBody<Real> body{};
  BasicCoefficients<Real> coefficients{};
};
using Vehicle = BasicVehicle<double>;

/// The controls, rad and m/s. Positive rudder turns to port; positive stern planes turn the nose
/// down.
struct Control {
  double delta_r = 0, delta_s = 0, delta_b = 0;  ///< rudder, stern planes, bow planes
  double u_c = 0;                                ///< commanded speed, set by the propeller
};

template <class Real>
using BasicVelocity = Eigen::Matrix<Real, 6, 1>;  ///< u v w p q r, body axes, m/s and rad/s
template <class Real>
using BasicWrench = Eigen::Matrix<Real, 6, 1>;  ///< X Y Z K M N, body axes, N and N m
template <class Real>
using BasicMatrix6 = Eigen::Matrix<Real, 6, 6>;
using Velocity = BasicVelocity<double>;
using Wrench = BasicWrench<double>;
using Matrix6 = BasicMatrix6<double>;

}  // namespace drydock::hydrodynamics
