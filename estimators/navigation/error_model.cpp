#include "estimators/navigation/error_model.hpp"

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/local_earth.hpp"

namespace drydock::navigation {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using frame::skew;

ErrorDynamics error_dynamics(const NavigationState& state, const Vector3d& force_ned,
                             const HeightLoop& loop) {
  const frame::LocalEarth earth =
      frame::local_earth(state.position.latitude_rad, state.position.height_m);
  const Vector3d& v = state.velocity_ned;
  const double north_arc = 1 / (earth.meridian_radius_m + state.position.height_m);
  const double east_arc = 1 / (earth.transverse_radius_m + state.position.height_m);
  const double tan = earth.tan_latitude, sec = 1 / earth.cos_latitude;
  const Vector3d earth_rate{earth.rate_north, 0, earth.rate_down};
  const Vector3d rho{v.y() * east_arc, -v.x() * north_arc, -v.y() * east_arc * tan};
  const double meridian_slope = earth.meridian_slope_m * north_arc;     // R_NN / (R_N + h)
  const double transverse_slope = earth.transverse_slope_m * east_arc;  // R_EE / (R_E + h)

  // Derivatives of omega_EN by latitude, height and velocity, and of omega_IE by latitude.
  const Vector3d rho_latitude{-rho.x() * transverse_slope, -rho.y() * meridian_slope,
                              -rho.x() * sec * sec - rho.z() * transverse_slope};
  const Vector3d rho_height{-rho.x() * east_arc, -rho.y() * north_arc, -rho.z() * east_arc};
  Matrix3d rho_velocity = Matrix3d::Zero();
  rho_velocity(0, 1) = east_arc;
  rho_velocity(1, 0) = -north_arc;
  rho_velocity(2, 1) = -tan * east_arc;
  const Vector3d earth_rate_latitude{earth.rate_down, 0, -earth.rate_north};
  const Matrix3d body_to_ned = state.body_to_ned.toRotationMatrix();

  ErrorDynamics f = ErrorDynamics::Zero();
  f(0, 0) = rho.y() * meridian_slope;  // F11
  f(0, 2) = rho.y() * north_arc;
  f(1, 0) = rho.x() * sec * (tan - transverse_slope);
  f(1, 2) = -rho.x() * sec * east_arc;
  f(2, 2) = -loop.k1;
  f(0, 3) = north_arc;  // F12
  f(1, 4) = sec * east_arc;
  f(2, 5) = -1;

  f.block<3, 1>(3, 0) = v.cross(2 * earth_rate_latitude + rho_latitude);  // F21
  f.block<3, 1>(3, 2) = v.cross(rho_height);
  f(5, 0) += earth.gravity_by_latitude;
  f(5, 2) += earth.gravity_by_height + loop.k2;
  f.block<3, 3>(3, 3) = skew(v) * rho_velocity - skew(2 * earth_rate + rho);  // F22
  f.block<3, 3>(3, 6) = skew(force_ned);                                      // F23
  f.block<3, 3>(3, 12) = body_to_ned;                                         // F25

  f.block<3, 1>(6, 0) = earth_rate_latitude + rho_latitude;  // F31
  f.block<3, 1>(6, 2) = rho_height;
  f.block<3, 3>(6, 3) = rho_velocity;             // F32
  f.block<3, 3>(6, 6) = -skew(earth_rate + rho);  // F33
  f.block<3, 3>(6, 9) = -body_to_ned;             // F34
  return f;
}

}  // namespace drydock::navigation
