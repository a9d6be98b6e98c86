#pragma once

#include "estimators/frame/local_earth_body.hpp"
#include "estimators/frame/skew.hpp"
#include "estimators/navigation/error_model.hpp"

namespace drydock::navigation {

template <class Real>
BasicErrorDynamics<Real> error_dynamics(const BasicNavigationState<Real>& state,
                                        const std::type_identity_t<Eigen::Vector3<Real>>& force_ned,
                                        const HeightLoop& loop) {
  return error_dynamics(state,
                        frame::local_earth(state.position.latitude_rad, state.position.height_m),
                        force_ned, loop);
}

template <class Real>
BasicErrorDynamics<Real> error_dynamics(const BasicNavigationState<Real>& state,
                                        const frame::BasicLocalEarth<Real>& earth,
                                        const Eigen::Vector3<Real>& force_ned,
                                        const HeightLoop& loop) {
  using Vector = Eigen::Vector3<Real>;
  using Matrix = Eigen::Matrix3<Real>;
  using frame::skew;
  const Vector& v = state.velocity_ned;
  const Real north_arc = 1 / (earth.meridian_radius_m + state.position.height_m);
  const Real east_arc = 1 / (earth.transverse_radius_m + state.position.height_m);
  const Real tan = earth.tan_latitude, sec = 1 / earth.cos_latitude;
  const Vector earth_rate{earth.rate_north, 0, earth.rate_down};
  const Vector rho{v.y() * east_arc, -v.x() * north_arc, -v.y() * east_arc * tan};
  const Real meridian_slope = earth.meridian_slope_m * north_arc;     // R_NN / (R_N + h)
  const Real transverse_slope = earth.transverse_slope_m * east_arc;  // R_EE / (R_E + h)

  // Derivatives of omega_EN by latitude, height and velocity, and of omega_IE by latitude.
  const Vector rho_latitude{-rho.x() * transverse_slope, -rho.y() * meridian_slope,
                            -rho.x() * sec * sec - rho.z() * transverse_slope};
  const Vector rho_height{-rho.x() * east_arc, -rho.y() * north_arc, -rho.z() * east_arc};
  Matrix rho_velocity = Matrix::Zero();
  rho_velocity(0, 1) = east_arc;
  rho_velocity(1, 0) = -north_arc;
  rho_velocity(2, 1) = -tan * east_arc;
  const Vector earth_rate_latitude{earth.rate_down, 0, -earth.rate_north};
  const Matrix body_to_ned = state.body_to_ned.toRotationMatrix();

  BasicErrorDynamics<Real> f = BasicErrorDynamics<Real>::Zero();
  f(0, 0) = rho.y() * meridian_slope;  // F11
  f(0, 2) = rho.y() * north_arc;
  f(1, 0) = rho.x() * sec * (tan - transverse_slope);
  f(1, 2) = -rho.x() * sec * east_arc;
  f(2, 2) = -loop.k1;
  f(0, 3) = north_arc;  // F12
  f(1, 4) = sec * east_arc;
  f(2, 5) = -1;

  f.template block<3, 1>(3, 0) = v.cross(2 * earth_rate_latitude + rho_latitude);  // F21
  f.template block<3, 1>(3, 2) = v.cross(rho_height);
  f(5, 0) += earth.gravity_by_latitude;
  f(5, 2) += earth.gravity_by_height + loop.k2;
  f.template block<3, 3>(3, 3) =
      skew<Real>(v) * rho_velocity - skew<Real>(2 * earth_rate + rho);  // F22
  f.template block<3, 3>(3, 6) = skew<Real>(force_ned);                 // F23
  f.template block<3, 3>(3, 12) = body_to_ned;                          // F25

  f.template block<3, 1>(6, 0) = earth_rate_latitude + rho_latitude;  // F31
  f.template block<3, 1>(6, 2) = rho_height;
  f.template block<3, 3>(6, 3) = rho_velocity;                   // F32
  f.template block<3, 3>(6, 6) = -skew<Real>(earth_rate + rho);  // F33
  f.template block<3, 3>(6, 9) = -body_to_ned;                   // F34
  return f;
}

}  // namespace drydock::navigation
