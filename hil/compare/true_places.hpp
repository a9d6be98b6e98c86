#pragma once

#include <vector>

#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::compare {

/// The way of a motion from its start to `end`, as so many points as a map needs.
std::vector<frame::Position> true_places(const motion::Trajectory& truth, measurement::Stamp end);

}  // namespace drydock::compare
