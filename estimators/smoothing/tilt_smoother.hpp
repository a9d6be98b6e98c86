#pragma once

#include <vector>

#include "estimators/smoothing/reading.hpp"

namespace drydock::smoothing {

/// Roll and pitch, freed from the noise of their sensor, with their rates: forward filter and
/// backward smoother of Singer's model, whose wandering and noise are the most likely ones. A DVL
/// ahead of the vehicle's origin feels the rate of pitch as a vertical velocity, and a single noisy
/// tilt turns speed ahead into one. Fewer than eight tilts are returned as they are.
std::vector<Tilt> smooth_tilts(std::vector<Tilt> measured);

}  // namespace drydock::smoothing
