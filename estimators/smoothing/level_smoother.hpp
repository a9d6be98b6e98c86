#pragma once

#include "estimators/smoothing/level_filter.hpp"

namespace drydock::smoothing {

/// The forward filter alone: the residuals of all readings of the dive, with their latencies.
Residuals level_residuals(const Dive& dive, const LevelOptions& options);

/// The forward filter and the backward smoother. An epoch is the time of one or more readings.
Track smooth_level(const Dive& dive, const LevelOptions& options);

/// A start at the first fix, heading and depth of the dive; `otherwise` where there is no fix.
LevelState level_start(const Dive& dive, const frame::Position& otherwise);

}  // namespace drydock::smoothing
