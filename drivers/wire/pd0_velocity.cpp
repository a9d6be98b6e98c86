#include "drivers/wire/pd0_velocity.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::wire {
namespace {

using Components = std::array<std::optional<double>, 4>;
using Vector = std::array<double, 3>;  // instrument axes X starboard, Y bow, Z mast unless said

/// The matrix of the coordinate transformation booklet (its eq. 18), transposed: from earth (or,
/// with heading 0, from levelled ship axes) to the instrument.
Vector levelled_to_instrument(const Vector& v, double heading, double pitch, double roll) {
  const double sh = std::sin(heading), ch = std::cos(heading);
  const double sp = std::sin(pitch), cp = std::cos(pitch);
  const double sr = std::sin(roll), cr = std::cos(roll);
  return {v[0] * (ch * cr + sh * sp * sr) + v[1] * (ch * sp * sr - sh * cr) - v[2] * cp * sr,
          v[0] * sh * cp + v[1] * ch * cp + v[2] * sp,
          v[0] * (ch * sr - sh * sp * cr) - v[1] * (sh * sr + ch * sp * cr) + v[2] * cp * cr};
}

/// Turns instrument axes about the mast so that Y is the ship's bow; beam 3 stands clockwise of it.
Vector aligned(const Vector& v, double alignment) {
  const double s = std::sin(alignment), c = std::cos(alignment);
  return {v[0] * c + v[1] * s, v[1] * c - v[0] * s, v[2]};
}

/// Janus geometry: beams 1 and 2 to port and starboard, 3 and 4 to bow and stern.
std::optional<Vector> from_beams(const Pd0FixedLeader& set_up, const Components& beam) {
  if (!set_up.beam_angle_rad) return std::nullopt;
  const auto bad = std::ranges::count_if(beam, [](const auto& b) { return !b; });
  if (bad > 1 || (bad == 1 && !set_up.three_beam)) return std::nullopt;
  // b1 + b2 = b3 + b4 where the error velocity is zero; that gives the one bad beam.
  std::array<double, 4> b;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t pair = i ^ 1, cross = i ^ 2;
    b[i] = beam[i] ? *beam[i] : *beam[cross] + *beam[cross ^ 1] - *beam[pair];
  }
  const double across = (set_up.convex ? 1 : -1) / (2 * std::sin(*set_up.beam_angle_rad));
  const double along = 1 / (4 * std::cos(*set_up.beam_angle_rad));
  return Vector{across * (b[0] - b[1]), across * (b[3] - b[2]),
                along * (b[0] + b[1] + b[2] + b[3])};
}

std::optional<Vector> first_three(const Components& v) {
  if (!v[0] || !v[1] || !v[2]) return std::nullopt;
  return Vector{*v[0], *v[1], *v[2]};
}

/// Undoes what the instrument did with its sensors; `heading` is of its beam 3.
std::optional<Vector> unlevelled(const std::optional<Vector>& v, const Pd0VariableLeader& sensors,
                                 double heading) {
  if (!v || !sensors.pitch_rad || !sensors.roll_rad) return std::nullopt;
  const double pitch = std::atan(std::tan(*sensors.pitch_rad) * std::cos(*sensors.roll_rad));
  return levelled_to_instrument(*v, heading, pitch, *sensors.roll_rad);
}

/// Ship axes: X starboard, Y bow, Z mast, tilting with the hull.
std::optional<Vector> in_ship_axes(const Pd0Ensemble& e) {
  const double alignment = e.fixed.heading_alignment_rad;
  const Components sent = finest_velocity(e);
  std::optional<Vector> v;
  switch (e.fixed.frame) {
    case Pd0Frame::beam: v = from_beams(e.fixed, sent); break;
    case Pd0Frame::instrument: v = first_three(sent); break;
    case Pd0Frame::ship:
      v = first_three(sent);
      if (!e.fixed.tilts_used) return v;
      v = unlevelled(v, e.variable, alignment);
      break;
    case Pd0Frame::earth:
      if (!e.variable.heading_rad) return std::nullopt;
      v = unlevelled(first_three(sent), e.variable, *e.variable.heading_rad + alignment);
      break;
  }
  if (!v) return std::nullopt;
  return aligned(*v, alignment);
}

}  // namespace

std::array<std::optional<double>, 4> finest_velocity(const Pd0Ensemble& ensemble) {
  if (!ensemble.high_resolution) {
    return ensemble.bottom_track ? ensemble.bottom_track->velocity_mps : Components{};
  }
  Components finest = ensemble.high_resolution->bottom_velocity_mps;
  if (!ensemble.bottom_track) return finest;
  const Components& coarse = ensemble.bottom_track->velocity_mps;
  for (std::size_t i = 0; i < finest.size(); ++i) {
    if (!finest[i] || !coarse[i]) finest[i] = coarse[i];
  }
  return finest;
}

std::optional<std::array<double, 3>> velocity_frd(const Pd0Ensemble& ensemble) {
  if (ensemble.fixed.faces_up) return std::nullopt;
  const auto v = in_ship_axes(ensemble);
  if (!v) return std::nullopt;
  return std::array{(*v)[1], (*v)[0], -(*v)[2]};
}

}  // namespace drydock::wire
