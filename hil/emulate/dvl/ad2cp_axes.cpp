#include "hil/emulate/dvl/ad2cp_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::emulate {
namespace {

using wire::ad2cp::Estimates;
using Weights = std::array<double, 4>;  ///< of beams 1 to 4

constexpr std::size_t opposite(std::size_t beam) { return beam ^ 2; }

/// The error velocity is taken as zero, so the lost beam is the sum of the other pair less the
/// opposite beam.
Weights without(std::size_t lost, Weights w) {
  for (std::size_t beam = 0; beam < w.size(); ++beam)
    if (beam != lost) w[beam] += beam == opposite(lost) ? -w[lost] : w[lost];
  w[lost] = 0;
  return w;
}

void set_axis(std::size_t axis, const Weights& w, const Estimates& beams, Estimates& axes) {
  double velocity = 0, variance = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (w[i] == 0) continue;
    velocity += w[i] * *beams.velocity_mps[i];
    variance += std::pow(w[i] * *beams.figure_of_merit_mps[i], 2);
  }
  axes.velocity_mps[axis] = velocity;
  axes.figure_of_merit_mps[axis] = std::sqrt(variance);
}

}  // namespace

void set_axes(const Estimates& beams, double beam_angle_rad, Estimates& axes) {
  const double k = 1 / (2 * std::numbers::sqrt2 * std::sin(beam_angle_rad));
  const double z = 1 / (2 * std::cos(beam_angle_rad));
  const Weights x{k, k, -k, -k}, y{k, -k, -k, k}, first_pair{z, 0, z, 0}, second_pair{0, z, 0, z};
  const auto none = [](const auto& velocity) { return !velocity; };
  const auto& found = beams.velocity_mps;
  const auto lost_beams = std::ranges::count_if(found, none);
  if (lost_beams > 1) return;
  if (lost_beams == 0) {
    set_axis(0, x, beams, axes);
    set_axis(1, y, beams, axes);
    set_axis(2, first_pair, beams, axes);
    set_axis(3, second_pair, beams, axes);
    return;
  }
  const auto lost = static_cast<std::size_t>(std::ranges::find_if(found, none) - found.begin());
  set_axis(0, without(lost, x), beams, axes);
  set_axis(1, without(lost, y), beams, axes);
  set_axis(2, lost % 2 == 0 ? second_pair : first_pair, beams, axes);
}

}  // namespace drydock::emulate
