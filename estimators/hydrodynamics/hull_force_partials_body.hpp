#pragma once

#include "estimators/hydrodynamics/hull_forces.hpp"

namespace drydock::hydrodynamics {

/// Eq. (A5). Each function returns one row: the derivatives of one force by u v w p q r.
template <class Real>
class HullPartials {
 public:
  using Row = Eigen::Matrix<Real, 1, 6>;

  HullPartials(const BasicCoefficients<Real>& coefficients, const BasicVelocity<Real>& velocity,
               const Control& control)
      : c(coefficients),
        u(velocity[0]),
        v(velocity[1]),
        w(velocity[2]),
        p(velocity[3]),
        q(velocity[4]),
        r(velocity[5]),
        dr(control.delta_r),
        ds(control.delta_s),
        db(control.delta_b),
        u_c(control.u_c) {}

  Row surge() const {
    const Real deflected = c.X_delta_r_delta_r * dr * dr + c.X_delta_s_delta_s * ds * ds +
                           c.X_delta_b_delta_b * db * db;
    return {2 * (c.X_uu + deflected + c.X_a) * u + c.X_b * u_c,
            2 * c.X_vv * v + c.X_vr * r,
            2 * c.X_ww * w + c.X_wq * q,
            c.X_rp * r,
            2 * c.X_qq * q + c.X_wq * w,
            2 * c.X_rr * r + c.X_rp * p + c.X_vr * v};
  }

  Row sway() const {
    const Real by_v_h = c.Y_v_abs_v * v + c.Y_v_abs_r * s_v * abs_r;
    return {2 * c.Y_star * u + c.Y_v * v + c.Y_r * r + c.Y_p * p +
                (c.Y_abs_r_delta_r * abs_r + 2 * c.Y_delta_r * u) * dr,
            c.Y_v * u + c.Y_vw * w + c.Y_vq * q + c.Y_v_abs_v * v_h + by_v_h * v_h_v,
            c.Y_vw * v + c.Y_wp * p + c.Y_wr * r + by_v_h * v_h_w,
            2 * c.Y_p_abs_p * abs_p + c.Y_pq * q + c.Y_wp * w + c.Y_p * u,
            c.Y_pq * p + c.Y_qr * r + c.Y_vq * v,
            c.Y_r * u + c.Y_qr * q + c.Y_wr * w +
                (c.Y_v_abs_r * s_v * v_h + c.Y_abs_r_delta_r * u * dr) * s_r};
  }

  Row heave() const {
    const Real by_v_h = c.Z_w_abs_w * w + c.Z_ww * abs_w + c.Z_w_abs_q * s_w * abs_q;
    return {2 * c.Z_star * u + c.Z_w * w + c.Z_abs_w * abs_w + c.Z_q * q +
                (c.Z_abs_q_delta_s * abs_q + 2 * c.Z_delta_s * u) * ds + 2 * c.Z_delta_b * u * db,
            2 * c.Z_vv * v + c.Z_vr * r + c.Z_vp * p + by_v_h * v_h_v,
            (c.Z_w + c.Z_abs_w * s_w) * u + (c.Z_w_abs_w + c.Z_ww * s_w) * v_h + by_v_h * v_h_w,
            2 * c.Z_pp * p + c.Z_rp * r + c.Z_vp * v,
            c.Z_q * u + (c.Z_abs_q_delta_s * u * ds + c.Z_w_abs_q * s_w * v_h) * s_q,
            2 * c.Z_rr * r + c.Z_rp * p + c.Z_vr * v};
  }

  Row roll() const {
    return {2 * c.K_star * u + c.K_v * v + c.K_p * p + c.K_r * r + 2 * c.K_delta_r * u * dr,
            c.K_v * u + c.K_vw * w + c.K_vq * q + c.K_v_abs_v * (v_h + v * v_h_v),
            c.K_vw * v + c.K_wp * p + c.K_wr * r + c.K_v_abs_v * v * v_h_w,
            2 * c.K_p_abs_p * abs_p + c.K_p * u + c.K_pq * q + c.K_wp * w,
            c.K_pq * p + c.K_qr * r + c.K_vq * v,
            c.K_r * u + c.K_qr * q + c.K_wr * w};
  }

  Row pitch() const {
    const Real by_v_h = c.M_w_abs_w * w + c.M_ww * abs_w + c.M_abs_w_q * q;
    return {
        2 * c.M_star * u + c.M_w * w + c.M_abs_w * abs_w + c.M_q * q +
            (c.M_abs_q_delta_s * abs_q + 2 * c.M_delta_s * u) * ds + 2 * c.M_delta_b * u * db,
        2 * c.M_vv * v + c.M_vr * r + c.M_vp * p + by_v_h * v_h_v,
        (c.M_w + c.M_abs_w * s_w) * u + (c.M_w_abs_w + c.M_ww * s_w) * v_h + by_v_h * v_h_w,
        2 * c.M_pp * p + c.M_rp * r + c.M_vp * v,
        2 * c.M_q_abs_q * abs_q + c.M_abs_q_delta_s * s_q * u * ds + c.M_q * u + c.M_abs_w_q * v_h,
        2 * c.M_rr * r + c.M_rp * p + c.M_vr * v};
  }

  Row yaw() const {
    const Real by_v_h = c.N_v_abs_v * v + c.N_abs_v_r * r;
    return {2 * c.N_star * u + c.N_v * v + c.N_r * r + c.N_p * p +
                (c.N_abs_r_delta_r * abs_r + 2 * c.N_delta_r * u) * dr,
            c.N_v * u + c.N_vw * w + c.N_vq * q + c.N_v_abs_v * v_h + by_v_h * v_h_v,
            c.N_vw * v + c.N_wp * p + c.N_wr * r + by_v_h * v_h_w,
            c.N_pq * q + c.N_wp * w + c.N_p * u,
            c.N_pq * p + c.N_qr * r + c.N_vq * v,
            c.N_r * u + c.N_qr * q + c.N_wr * w + c.N_abs_v_r * v_h + 2 * c.N_r_abs_r * abs_r +
                c.N_abs_r_delta_r * s_r * u * dr};
  }

 private:
  static Real magnitude(const Real& x) {
    using lanes::abs;
    return abs(x);
  }

  const BasicCoefficients<Real>& c;
  const Real u, v, w, p, q, r;
  const double dr, ds, db, u_c;
  const Real v_h = cross_flow_speed(v, w);
  const Real v_h_v = v / v_h, v_h_w = w / v_h;  ///< derivatives of v_h by v and w
  const Real s_v = sign(v), s_w = sign(w), s_q = sign(q), s_r = sign(r);
  const Real abs_w = magnitude(w), abs_p = magnitude(p), abs_q = magnitude(q), abs_r = magnitude(r);
};

template <class Real>
BasicMatrix6<Real> hull_force_partials(const BasicCoefficients<Real>& c,
                                       const std::type_identity_t<BasicVelocity<Real>>& velocity,
                                       const Control& control) {
  const HullPartials<Real> partials(c, velocity, control);
  BasicMatrix6<Real> rows;
  rows.row(0) = partials.surge();
  rows.row(1) = partials.sway();
  rows.row(2) = partials.heave();
  rows.row(3) = partials.roll();
  rows.row(4) = partials.pitch();
  rows.row(5) = partials.yaw();
  return rows;
}

}  // namespace drydock::hydrodynamics
