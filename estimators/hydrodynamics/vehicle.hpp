#pragma once

#include <Eigen/Core>

#include "estimators/hydrodynamics/coefficients.hpp"

namespace drydock::hydrodynamics {

/// Mass properties about the origin of the body axes. The coefficients hold in the same axes. Both
/// centres lie on the z axis: r_G = [0 0 z_G], r_B = [0 0 z_B]. SI.
struct RigidBody {
  double mass = 0;
  double weight = 0, buoyancy = 0;                              ///< W, B; N
  double z_G = 0, z_B = 0;                                      ///< positive below the origin
  Eigen::Vector3d moments_of_inertia{Eigen::Vector3d::Zero()};  ///< I_x I_y I_z
};

struct Vehicle {
  RigidBody body{};
  Coefficients coefficients{};
};

/// The controls, rad and m/s. Positive rudder turns to port; positive stern planes turn the nose
/// down.
struct Control {
  double delta_r = 0, delta_s = 0, delta_b = 0;  ///< rudder, stern planes, bow planes
  double u_c = 0;                                ///< commanded speed, set by the propeller
};

using Velocity = Eigen::Matrix<double, 6, 1>;  ///< u v w p q r, body axes, m/s and rad/s
using Wrench = Eigen::Matrix<double, 6, 1>;    ///< X Y Z K M N, body axes, N and N m
using Matrix6 = Eigen::Matrix<double, 6, 6>;

}  // namespace drydock::hydrodynamics
