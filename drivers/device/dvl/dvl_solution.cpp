#include "drivers/device/dvl/dvl_solution.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::device {

namespace {

/// Names the missing data that the conversion to the body needs, in words.
std::string_view missing_for(const wire::DvlGeometry& geometry, const wire::DvlAttitude& attitude) {
  using enum wire::DvlFrame;
  if (!wire::is_of_the_bed(geometry))
    return "no velocity: an upward-facing head gives it in its own axes, so it is not of the bed";
  if (geometry.frame == beam) {
    return geometry.beam_angle_rad ? "" : "no velocity: beam velocities, but no beam_angle_deg";
  }
  const bool levelled = geometry.frame == earth || (geometry.frame == ship && geometry.tilts_used);
  if (levelled && (!attitude.pitch_rad || !attitude.roll_rad)) {
    return "no velocity: it comes levelled, but without the pitch and roll to undo that";
  }
  if (geometry.frame == earth && !attitude.heading_rad) {
    return "no velocity: it comes in earth axes, but without the heading to undo that";
  }
  return "";
}

bool any(const wire::DvlComponents& sent) {
  return std::ranges::any_of(sent, [](const auto& component) { return component.has_value(); });
}

}  // namespace

std::optional<Eigen::Vector3d> DvlSolution::velocity(const wire::DvlComponents& sent,
                                                     wire::DvlGeometry geometry,
                                                     const wire::DvlAttitude& attitude,
                                                     Output& out) {
  if (dvl_.maker == DvlMaker::water_linked) {
    const auto& [x, y, z, error] = sent;
    if (!x || !y || !z) return {};
    return mounting_.to_body({*x, *y, *z});
  }
  if (!geometry.beam_angle_rad) geometry.beam_angle_rad = dvl_.beam_angle_rad;
  if (dvl_.levelled && geometry.frame == wire::DvlFrame::ship) geometry.tilts_used = *dvl_.levelled;
  if (any(sent)) heed(missing_for(geometry, attitude), out);
  const auto v = wire::velocity_frd(sent, geometry, attitude);
  if (!v) return {};
  return mounting_.to_body({(*v)[0], (*v)[1], (*v)[2]});
}

void DvlSolution::heed(std::string_view missing, Output& out) {
  if (!missing.empty() && missing != missing_) out.report(missing);
  missing_ = missing;
}

/// The vertical component of a beam's range is d = h cos(b) / (n.u). Here u is the slant of the
/// beam and n the down vector in instrument axes. In a Janus pair the tilt terms of 1/d cancel:
/// 1/d1 + 1/d2 = 2 n_z / h. Thus h is n_z = cos(pitch) cos(roll) times the harmonic mean.
std::optional<double> altitude_over_bed(const std::array<std::optional<double>, 4>& range_m,
                                        const wire::DvlAttitude& tilt) {
  if (!tilt.pitch_rad || !tilt.roll_rad) return {};
  double inverse_sum = 0;
  int beams = 0;
  for (const std::size_t first : {0U, 2U}) {  // opposite beams: 1 and 2, 3 and 4
    if (!range_m[first] || !range_m[first + 1]) continue;
    inverse_sum += 1 / *range_m[first] + 1 / *range_m[first + 1];
    beams += 2;
  }
  if (beams == 0) return {};
  const double pitch = wire::euler_pitch(*tilt.pitch_rad, *tilt.roll_rad);
  return std::cos(pitch) * std::cos(*tilt.roll_rad) * beams / inverse_sum;
}

}  // namespace drydock::device
