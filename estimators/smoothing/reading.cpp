#include "estimators/smoothing/reading.hpp"

#include <algorithm>

namespace drydock::smoothing {

Tilt tilt_at(const std::vector<Tilt>& tilts, double time_s) {
  if (tilts.empty()) return {time_s, 0, 0};
  const auto next = std::ranges::lower_bound(tilts, time_s, {}, &Tilt::time_s);
  if (next == tilts.begin()) return tilts.front();
  if (next == tilts.end()) return tilts.back();
  const Tilt& last = *std::prev(next);
  const double part = (time_s - last.time_s) / (next->time_s - last.time_s);
  return {time_s, last.roll_rad + part * (next->roll_rad - last.roll_rad),
          last.pitch_rad + part * (next->pitch_rad - last.pitch_rad)};
}

}  // namespace drydock::smoothing
