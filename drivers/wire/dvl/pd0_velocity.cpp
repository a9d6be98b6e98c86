#include "drivers/wire/dvl/pd0_velocity.hpp"

namespace drydock::wire {

DvlComponents finest_velocity(const Pd0Ensemble& ensemble) {
  if (!ensemble.high_resolution) {
    return ensemble.bottom_track ? ensemble.bottom_track->velocity_mps : DvlComponents{};
  }
  DvlComponents finest = ensemble.high_resolution->bottom_velocity_mps;
  if (!ensemble.bottom_track) return finest;
  const DvlComponents& coarse = ensemble.bottom_track->velocity_mps;
  for (std::size_t i = 0; i < finest.size(); ++i) {
    if (!finest[i] || !coarse[i]) finest[i] = coarse[i];
  }
  return finest;
}

std::optional<std::array<double, 3>> velocity_frd(const Pd0Ensemble& ensemble) {
  return velocity_frd(finest_velocity(ensemble), ensemble.fixed, ensemble.variable);
}

}  // namespace drydock::wire
