#pragma once

#include "estimators/smoothing/level_filter.hpp"

namespace drydock::smoothing {

/// A sensor whose noise neither it nor the rig states.
struct UnstatedNoise {
  Quantity quantity = Quantity::bottom;
  std::uint16_t device = 0;
};

struct NoiseFit {
  LevelMotion motion;           ///< its velocity and its turn are fitted
  std::vector<double> factors;  ///< on the sigmas of each unstated one
};

/// ln of the likelihood of the readings: -1/2 sum (e2/s2 + ln s2) over their residuals e with the
/// deviation s, up to a constant. Outside the gate e2/s2 counts only by its logarithm: a wild
/// reading must not shape the motion, and a motion that refuses its readings must not win.
double log_likelihood(const Residuals& residuals, double gate_sigma);

/// The wandering of the vehicle and the unstated noise that make the readings most likely, eq.
/// (S12). It looks at the middle 40,000 readings of a longer dive.
NoiseFit fit_noise(const Dive& dive, const LevelOptions& options,
                   const std::vector<UnstatedNoise>& unstated);

/// Multiplies the sigmas of a sensor's readings.
void scale_noise(Dive& dive, const UnstatedNoise& sensor, double factor);

}  // namespace drydock::smoothing
