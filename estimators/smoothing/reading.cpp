#include "estimators/smoothing/reading.hpp"

#include <algorithm>

namespace drydock::smoothing {
namespace {

/// Over a longer step the rates at its ends say nothing of its middle.
constexpr double longest_cubic_s = 5;

/// Hermite's cubic at the part `u` of a step of `h` seconds.
double cubic(double from, double rate_from, double to, double rate_to, double u, double h) {
  const double v = 1 - u;
  return v * v * ((1 + 2 * u) * from + u * h * rate_from) +
         u * u * ((1 + 2 * v) * to - v * h * rate_to);
}

}  // namespace

Tilt tilt_at(const std::vector<Tilt>& tilts, double time_s) {
  if (tilts.empty()) return {time_s, 0, 0};
  const auto found = std::ranges::lower_bound(tilts, time_s, {}, &Tilt::time_s);
  if (found == tilts.begin()) return tilts.front();
  if (found == tilts.end()) return tilts.back();
  const Tilt &last = *std::prev(found), &next = *found;
  const double step_s = next.time_s - last.time_s, part = (time_s - last.time_s) / step_s;
  const auto between = [&](double Tilt::*value) {
    return last.*value + part * (next.*value - last.*value);
  };
  if (step_s > longest_cubic_s)
    return {time_s, between(&Tilt::roll_rad), between(&Tilt::pitch_rad),
            (next.roll_rad - last.roll_rad) / step_s, (next.pitch_rad - last.pitch_rad) / step_s};
  const auto curved = [&](double Tilt::*angle, double Tilt::*rate) {
    return cubic(last.*angle, last.*rate, next.*angle, next.*rate, part, step_s);
  };
  return {time_s, curved(&Tilt::roll_rad, &Tilt::roll_radps),
          curved(&Tilt::pitch_rad, &Tilt::pitch_radps), between(&Tilt::roll_radps),
          between(&Tilt::pitch_radps)};
}

}  // namespace drydock::smoothing
