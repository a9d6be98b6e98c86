#pragma once

#include <optional>
#include <span>

#include "drivers/measurement/measurement.hpp"

namespace drydock::sky {

/// Dilution of precision: error of the solution divided by the error of one range. It depends only
/// on the satellites' directions (docs/world/sky.md eq. (17)).
struct Dilution {
  double geometric = 0, position = 0, horizontal = 0, vertical = 0, time = 0;
};

/// Uses the satellites in use that have a direction. Empty if they do not fix a position: fewer
/// than four, or all on one cone around the receiver.
std::optional<Dilution> dilution(std::span<const measurement::Satellite> satellites);

}  // namespace drydock::sky
