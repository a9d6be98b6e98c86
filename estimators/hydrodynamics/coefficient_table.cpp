#include "estimators/hydrodynamics/coefficient_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drydock::hydrodynamics {

namespace {

using C = Coefficients;

constexpr auto table = std::to_array<NamedCoefficient>({
    {"X", "udot", 3, &C::X_udot},
    {"X", "uu", 2, &C::X_uu},
    {"X", "vv", 2, &C::X_vv},
    {"X", "ww", 2, &C::X_ww},
    {"X", "qq", 4, &C::X_qq},
    {"X", "rr", 4, &C::X_rr},
    {"X", "rp", 4, &C::X_rp},
    {"X", "vr", 3, &C::X_vr},
    {"X", "wq", 3, &C::X_wq},
    {"X", "delta_r_delta_r", 2, &C::X_delta_r_delta_r},
    {"X", "delta_s_delta_s", 2, &C::X_delta_s_delta_s},
    {"X", "delta_b_delta_b", 2, &C::X_delta_b_delta_b},
    {"X", "a", 2, &C::X_a},
    {"X", "b", 2, &C::X_b},
    {"X", "c", 2, &C::X_c},
    {"Y", "pdot", 4, &C::Y_pdot},
    {"Y", "rdot", 4, &C::Y_rdot},
    {"Y", "vdot", 3, &C::Y_vdot},
    {"Y", "*", 2, &C::Y_star},
    {"Y", "v", 2, &C::Y_v},
    {"Y", "vw", 2, &C::Y_vw},
    {"Y", "v|v|", 2, &C::Y_v_abs_v},
    {"Y", "|r|delta_r", 3, &C::Y_abs_r_delta_r},
    {"Y", "delta_r", 2, &C::Y_delta_r},
    {"Y", "p|p|", 4, &C::Y_p_abs_p},
    {"Y", "pq", 4, &C::Y_pq},
    {"Y", "qr", 4, &C::Y_qr},
    {"Y", "vq", 3, &C::Y_vq},
    {"Y", "wp", 3, &C::Y_wp},
    {"Y", "wr", 3, &C::Y_wr},
    {"Y", "r", 3, &C::Y_r},
    {"Y", "p", 3, &C::Y_p},
    {"Y", "v|r|", 3, &C::Y_v_abs_r},
    {"Z", "qdot", 4, &C::Z_qdot},
    {"Z", "wdot", 3, &C::Z_wdot},
    {"Z", "*", 2, &C::Z_star},
    {"Z", "w", 2, &C::Z_w},
    {"Z", "|w|", 2, &C::Z_abs_w},
    {"Z", "vv", 2, &C::Z_vv},
    {"Z", "w|w|", 2, &C::Z_w_abs_w},
    {"Z", "ww", 2, &C::Z_ww},
    {"Z", "|q|delta_s", 3, &C::Z_abs_q_delta_s},
    {"Z", "delta_s", 2, &C::Z_delta_s},
    {"Z", "delta_b", 2, &C::Z_delta_b},
    {"Z", "pp", 4, &C::Z_pp},
    {"Z", "rr", 4, &C::Z_rr},
    {"Z", "rp", 4, &C::Z_rp},
    {"Z", "vr", 3, &C::Z_vr},
    {"Z", "vp", 3, &C::Z_vp},
    {"Z", "q", 3, &C::Z_q},
    {"Z", "w|q|", 3, &C::Z_w_abs_q},
    {"K", "pdot", 5, &C::K_pdot},
    {"K", "rdot", 5, &C::K_rdot},
    {"K", "vdot", 4, &C::K_vdot},
    {"K", "*", 3, &C::K_star},
    {"K", "v", 3, &C::K_v},
    {"K", "vw", 3, &C::K_vw},
    {"K", "v|v|", 3, &C::K_v_abs_v},
    {"K", "delta_r", 3, &C::K_delta_r},
    {"K", "qr", 5, &C::K_qr},
    {"K", "pq", 5, &C::K_pq},
    {"K", "p|p|", 5, &C::K_p_abs_p},
    {"K", "p", 4, &C::K_p},
    {"K", "r", 4, &C::K_r},
    {"K", "vq", 4, &C::K_vq},
    {"K", "wp", 4, &C::K_wp},
    {"K", "wr", 4, &C::K_wr},
    {"M", "qdot", 5, &C::M_qdot},
    {"M", "wdot", 4, &C::M_wdot},
    {"M", "*", 3, &C::M_star},
    {"M", "vv", 3, &C::M_vv},
    {"M", "w", 3, &C::M_w},
    {"M", "|w|", 3, &C::M_abs_w},
    {"M", "w|w|", 3, &C::M_w_abs_w},
    {"M", "ww", 3, &C::M_ww},
    {"M", "|q|delta_s", 4, &C::M_abs_q_delta_s},
    {"M", "delta_s", 3, &C::M_delta_s},
    {"M", "delta_b", 3, &C::M_delta_b},
    {"M", "pp", 5, &C::M_pp},
    {"M", "rr", 5, &C::M_rr},
    {"M", "rp", 5, &C::M_rp},
    {"M", "q|q|", 5, &C::M_q_abs_q},
    {"M", "vr", 4, &C::M_vr},
    {"M", "vp", 4, &C::M_vp},
    {"M", "q", 4, &C::M_q},
    {"M", "|w|q", 4, &C::M_abs_w_q},
    {"N", "pdot", 5, &C::N_pdot},
    {"N", "rdot", 5, &C::N_rdot},
    {"N", "vdot", 4, &C::N_vdot},
    {"N", "*", 3, &C::N_star},
    {"N", "v", 3, &C::N_v},
    {"N", "vw", 3, &C::N_vw},
    {"N", "v|v|", 3, &C::N_v_abs_v},
    {"N", "|r|delta_r", 4, &C::N_abs_r_delta_r},
    {"N", "delta_r", 3, &C::N_delta_r},
    {"N", "pq", 5, &C::N_pq},
    {"N", "qr", 5, &C::N_qr},
    {"N", "r|r|", 5, &C::N_r_abs_r},
    {"N", "wr", 4, &C::N_wr},
    {"N", "wp", 4, &C::N_wp},
    {"N", "vq", 4, &C::N_vq},
    {"N", "p", 4, &C::N_p},
    {"N", "r", 4, &C::N_r},
    {"N", "|v|r", 4, &C::N_abs_v_r},
});

}  // namespace

std::span<const NamedCoefficient> coefficient_table() { return table; }

const NamedCoefficient* find_coefficient(std::string_view axis, std::string_view name) {
  const auto found = std::ranges::find_if(table, [&](const NamedCoefficient& entry) {
    return entry.axis == axis && entry.name == name;
  });
  return found == table.end() ? nullptr : &*found;
}

double prime_unit(int length_power, double density, double length) {
  return density / 2 * std::pow(length, length_power);
}

}  // namespace drydock::hydrodynamics
