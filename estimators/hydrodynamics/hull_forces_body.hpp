#pragma once

#include "estimators/hydrodynamics/hull_forces.hpp"

namespace drydock::hydrodynamics {

/// F^s, M^s: forces of a drift without rotation.
template <class Real>
BasicWrench<Real> static_forces(const BasicCoefficients<Real>& c,
                                const BasicVelocity<Real>& velocity) {
  using lanes::abs;
  const Real u = velocity[0], v = velocity[1], w = velocity[2];
  const Real abs_w = abs(w), v_h = cross_flow_speed(v, w);
  return {c.X_uu * u * u + c.X_vv * v * v + c.X_ww * w * w,
          c.Y_star * u * u + (c.Y_v * u + c.Y_vw * w + c.Y_v_abs_v * v_h) * v,
          c.Z_star * u * u + (c.Z_w * w + c.Z_abs_w * abs_w) * u + c.Z_vv * v * v +
              (c.Z_w_abs_w * w + c.Z_ww * abs_w) * v_h,
          c.K_star * u * u + (c.K_v * u + c.K_vw * w + c.K_v_abs_v * v_h) * v,
          c.M_star * u * u + (c.M_w * w + c.M_abs_w * abs_w) * u + c.M_vv * v * v +
              (c.M_w_abs_w * w + c.M_ww * abs_w) * v_h,
          c.N_star * u * u + (c.N_v * u + c.N_vw * w + c.N_v_abs_v * v_h) * v};
}

/// F^c, M^c: forces of rudder, planes and thrust.
template <class Real>
BasicWrench<Real> control_forces(const BasicCoefficients<Real>& c,
                                 const BasicVelocity<Real>& velocity, const Control& control) {
  using lanes::abs;
  const Real u = velocity[0], abs_q = abs(velocity[4]), abs_r = abs(velocity[5]);
  const auto& [delta_r, delta_s, delta_b, u_c] = control;
  return {
      (c.X_delta_r_delta_r * delta_r * delta_r + c.X_delta_s_delta_s * delta_s * delta_s +
       c.X_delta_b_delta_b * delta_b * delta_b + c.X_a) *
              u * u +
          c.X_b * u * u_c + c.X_c * u_c * u_c,
      (c.Y_abs_r_delta_r * abs_r + c.Y_delta_r * u) * u * delta_r,
      (c.Z_abs_q_delta_s * abs_q + c.Z_delta_s * u) * u * delta_s + c.Z_delta_b * u * u * delta_b,
      c.K_delta_r * u * u * delta_r,
      (c.M_abs_q_delta_s * abs_q + c.M_delta_s * u) * u * delta_s + c.M_delta_b * u * u * delta_b,
      (c.N_abs_r_delta_r * abs_r + c.N_delta_r * u) * u * delta_r};
}

/// F^d, M^d: forces of the rotation.
template <class Real>
BasicWrench<Real> damping_forces(const BasicCoefficients<Real>& c,
                                 const BasicVelocity<Real>& velocity) {
  using lanes::abs;
  const Real u = velocity[0], v = velocity[1], w = velocity[2];
  const Real p = velocity[3], q = velocity[4], r = velocity[5];
  const Real v_h = cross_flow_speed(v, w);
  return {
      c.X_qq * q * q + c.X_rr * r * r + c.X_rp * r * p + c.X_vr * v * r + c.X_wq * w * q,
      c.Y_p_abs_p * p * abs(p) + c.Y_pq * p * q + c.Y_qr * q * r + c.Y_vq * v * q + c.Y_wp * w * p +
          c.Y_wr * w * r + c.Y_r * u * r + c.Y_p * u * p + c.Y_v_abs_r * sign(v) * v_h * abs(r),
      c.Z_pp * p * p + c.Z_rr * r * r + c.Z_rp * r * p + c.Z_vr * v * r + c.Z_vp * v * p +
          c.Z_q * u * q + c.Z_w_abs_q * sign(w) * v_h * abs(q),
      c.K_qr * q * r + c.K_pq * p * q + c.K_p_abs_p * p * abs(p) + c.K_p * u * p + c.K_r * u * r +
          c.K_vq * v * q + c.K_wp * w * p + c.K_wr * w * r,
      c.M_pp * p * p + c.M_rr * r * r + c.M_rp * r * p + c.M_q_abs_q * q * abs(q) + c.M_vr * v * r +
          c.M_vp * v * p + c.M_q * u * q + c.M_abs_w_q * v_h * q,
      c.N_pq * p * q + c.N_qr * q * r + c.N_r_abs_r * r * abs(r) + c.N_wr * w * r + c.N_wp * w * p +
          c.N_vq * v * q + c.N_p * u * p + c.N_r * u * r + c.N_abs_v_r * v_h * r};
}

template <class Real>
BasicWrench<Real> hull_forces(const BasicCoefficients<Real>& c,
                              const std::type_identity_t<BasicVelocity<Real>>& velocity,
                              const Control& control) {
  return static_forces(c, velocity) + control_forces(c, velocity, control) +
         damping_forces(c, velocity);
}

}  // namespace drydock::hydrodynamics
