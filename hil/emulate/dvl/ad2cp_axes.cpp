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

/// Of X, Y, Z1 and Z2.
std::array<Weights, 4> weights_of_axes(double beam_angle_rad) {
  const double k = 1 / (2 * std::numbers::sqrt2 * std::sin(beam_angle_rad));
  const double z = 1 / (2 * std::cos(beam_angle_rad));
  return {Weights{k, k, -k, -k}, {k, -k, -k, k}, {z, 0, z, 0}, {0, z, 0, z}};
}

void give_up_beam(std::size_t lost, std::array<Weights, 4>& axes) {
  axes[0] = without(lost, axes[0]);
  axes[1] = without(lost, axes[1]);
  if (lost % 2 == 0) axes[2] = axes[3];
}

}  // namespace

void set_axes(const Estimates& beams, double beam_angle_rad, Estimates& axes) {
  const auto none = [](const auto& velocity) { return !velocity; };
  const auto& found = beams.velocity_mps;
  const auto lost_beams = std::ranges::count_if(found, none);
  if (lost_beams > 1) return;
  auto weights = weights_of_axes(beam_angle_rad);
  const auto lost = static_cast<std::size_t>(std::ranges::find_if(found, none) - found.begin());
  if (lost_beams == 1) give_up_beam(lost, weights);
  for (std::size_t axis = 0; axis < (lost_beams == 0 ? 4U : 3U); ++axis)
    set_axis(axis, weights[axis], beams, axes);
}

}  // namespace drydock::emulate
