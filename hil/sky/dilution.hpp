#pragma once

#include <optional>
#include <span>

#include "drivers/measurement/measurement.hpp"

namespace drydock::sky {

/// Dilution of precision: error of the solution over that of one range, by the satellites' places
/// alone (docs/world/sky.md eq. (17)).
struct Dilution {
  double geometric = 0, position = 0, horizontal = 0, vertical = 0, time = 0;
};

/// Of the satellites in use that have a direction. Nothing where they do not fix a position: fewer
/// than four, or all on one cone around the receiver.
std::optional<Dilution> dilution(std::span<const measurement::Satellite> satellites);

}  // namespace drydock::sky
