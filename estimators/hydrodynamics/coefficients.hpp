#pragma once

/// The coefficients of the standard submarine equations (Gertler and Hagen, NSRDC Report 2510,
/// 1967) in the form of eq. (3) of docs/estimators/hydrodynamics.md.
namespace drydock::hydrodynamics {

/// The names follow the report: `Y_v_abs_r` is Y_{v|r|}, `M_abs_w_q` is M_{|w|q}, `Z_star` is Z_*.
/// Dimensional, SI: the prime value times rho/2 L^n; coefficient_table.hpp gives n. A coefficient
/// that is not given is 0.
template <class Real>
struct BasicCoefficients {
  // surge force: added mass; static; control and thrust; damping
  Real X_udot = 0;
  Real X_uu = 0, X_vv = 0, X_ww = 0;
  Real X_delta_r_delta_r = 0, X_delta_s_delta_s = 0, X_delta_b_delta_b = 0, X_a = 0, X_b = 0,
       X_c = 0;
  Real X_qq = 0, X_rr = 0, X_rp = 0, X_vr = 0, X_wq = 0;

  // sway force: added mass; static; control; damping
  Real Y_pdot = 0, Y_rdot = 0, Y_vdot = 0;
  Real Y_star = 0, Y_v = 0, Y_vw = 0, Y_v_abs_v = 0;
  Real Y_abs_r_delta_r = 0, Y_delta_r = 0;
  Real Y_p_abs_p = 0, Y_pq = 0, Y_qr = 0, Y_vq = 0, Y_wp = 0, Y_wr = 0, Y_r = 0, Y_p = 0,
       Y_v_abs_r = 0;

  // heave force: added mass; static; control; damping
  Real Z_qdot = 0, Z_wdot = 0;
  Real Z_star = 0, Z_w = 0, Z_abs_w = 0, Z_vv = 0, Z_w_abs_w = 0, Z_ww = 0;
  Real Z_abs_q_delta_s = 0, Z_delta_s = 0, Z_delta_b = 0;
  Real Z_pp = 0, Z_rr = 0, Z_rp = 0, Z_vr = 0, Z_vp = 0, Z_q = 0, Z_w_abs_q = 0;

  // roll moment: added mass; static; control; damping
  Real K_pdot = 0, K_rdot = 0, K_vdot = 0;
  Real K_star = 0, K_v = 0, K_vw = 0, K_v_abs_v = 0;
  Real K_delta_r = 0;
  Real K_qr = 0, K_pq = 0, K_p_abs_p = 0, K_p = 0, K_r = 0, K_vq = 0, K_wp = 0, K_wr = 0;

  // pitch moment: added mass; static; control; damping
  Real M_qdot = 0, M_wdot = 0;
  Real M_star = 0, M_vv = 0, M_w = 0, M_abs_w = 0, M_w_abs_w = 0, M_ww = 0;
  Real M_abs_q_delta_s = 0, M_delta_s = 0, M_delta_b = 0;
  Real M_pp = 0, M_rr = 0, M_rp = 0, M_q_abs_q = 0, M_vr = 0, M_vp = 0, M_q = 0, M_abs_w_q = 0;

  // yaw moment: added mass; static; control; damping
  Real N_pdot = 0, N_rdot = 0, N_vdot = 0;
  Real N_star = 0, N_v = 0, N_vw = 0, N_v_abs_v = 0;
  Real N_abs_r_delta_r = 0, N_delta_r = 0;
  Real N_pq = 0, N_qr = 0, N_r_abs_r = 0, N_wr = 0, N_wp = 0, N_vq = 0, N_p = 0, N_r = 0,
       N_abs_v_r = 0;
};
using Coefficients = BasicCoefficients<double>;

}  // namespace drydock::hydrodynamics
