#include "drivers/wire/dvl/dvl_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::wire {
namespace {

using Vector = std::array<double, 3>;  // instrument axes X starboard, Y bow, Z mast, unless stated

/// The transposed matrix of the coordinate transformation booklet (its eq. 18). It goes to the
/// instrument from earth or, with heading 0, from levelled ship axes.
Vector levelled_to_instrument(const Vector& v, double heading, double pitch, double roll) {
  const double sh = std::sin(heading), ch = std::cos(heading);
  const double sp = std::sin(pitch), cp = std::cos(pitch);
  const double sr = std::sin(roll), cr = std::cos(roll);
  return {v[0] * (ch * cr + sh * sp * sr) + v[1] * (ch * sp * sr - sh * cr) - v[2] * cp * sr,
          v[0] * sh * cp + v[1] * ch * cp + v[2] * sp,
          v[0] * (ch * sr - sh * sp * cr) - v[1] * (sh * sr + ch * sp * cr) + v[2] * cp * cr};
}

/// Rotates instrument axes about the mast so that Y is the ship's bow. Beam 3 is clockwise of the
/// bow.
Vector aligned(const Vector& v, double alignment) {
  const double s = std::sin(alignment), c = std::cos(alignment);
  return {v[0] * c + v[1] * s, v[1] * c - v[0] * s, v[2]};
}

/// Janus geometry: beams 1 and 2 point to port and starboard, 3 and 4 to bow and stern.
std::optional<Vector> from_beams(const DvlGeometry& set_up, const DvlComponents& beam) {
  if (!set_up.beam_angle_rad) return std::nullopt;
  const auto bad = std::ranges::count_if(beam, [](const auto& b) { return !b; });
  if (bad > 1 || (bad == 1 && !set_up.three_beam)) return std::nullopt;
  // If the error velocity is zero, b1 + b2 = b3 + b4. That gives the single bad beam.
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

std::optional<Vector> first_three(const DvlComponents& v) {
  if (!v[0] || !v[1] || !v[2]) return std::nullopt;
  return Vector{*v[0], *v[1], *v[2]};
}

/// Undoes the levelling that the instrument did with its sensors. `heading` is that of its beam 3.
std::optional<Vector> unlevelled(const std::optional<Vector>& v, const DvlAttitude& sensors,
                                 double heading) {
  if (!v || !sensors.pitch_rad || !sensors.roll_rad) return std::nullopt;
  return levelled_to_instrument(*v, heading, euler_pitch(*sensors.pitch_rad, *sensors.roll_rad),
                                *sensors.roll_rad);
}

/// Ship axes: X starboard, Y bow, Z mast. They tilt with the hull.
std::optional<Vector> in_ship_axes(const DvlComponents& sent, const DvlGeometry& set_up,
                                   const DvlAttitude& sensors) {
  const double alignment = set_up.heading_alignment_rad;
  std::optional<Vector> v;
  switch (set_up.frame) {
    case DvlFrame::beam: v = from_beams(set_up, sent); break;
    case DvlFrame::instrument: v = first_three(sent); break;
    case DvlFrame::ship:
      v = first_three(sent);
      if (!set_up.tilts_used) return v;
      v = unlevelled(v, sensors, alignment);
      break;
    case DvlFrame::earth:
      if (!sensors.heading_rad) return std::nullopt;
      v = unlevelled(first_three(sent), sensors, *sensors.heading_rad + alignment);
      break;
  }
  if (!v) return std::nullopt;
  return aligned(*v, alignment);
}

}  // namespace

std::optional<double> error_velocity(const DvlComponents& sent, const DvlGeometry& geometry) {
  if (geometry.frame != DvlFrame::beam) return sent[3];
  const bool complete = std::ranges::all_of(sent, [](const auto& b) { return b.has_value(); });
  if (!complete || !geometry.beam_angle_rad) return {};
  const double scale = 1 / (2 * std::numbers::sqrt2 * std::sin(*geometry.beam_angle_rad));
  return scale * (*sent[0] + *sent[1] - *sent[2] - *sent[3]);
}

std::string_view to_string(DvlFrame frame) {
  constexpr std::array<std::string_view, 4> names{"beam", "instrument", "ship", "earth"};
  return names[static_cast<std::size_t>(frame)];
}

double euler_pitch(double sensor_pitch_rad, double roll_rad) {
  return std::atan(std::tan(sensor_pitch_rad) * std::cos(roll_rad));
}

std::optional<std::array<double, 3>> velocity_frd(const DvlComponents& velocity,
                                                  const DvlGeometry& geometry,
                                                  const DvlAttitude& attitude) {
  if (!is_of_the_bed(geometry)) return std::nullopt;
  const auto v = in_ship_axes(velocity, geometry, attitude);
  if (!v) return std::nullopt;
  return std::array{(*v)[1], (*v)[0], -(*v)[2]};
}

}  // namespace drydock::wire
