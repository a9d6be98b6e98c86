#pragma once

#include <optional>
#include <span>

namespace drydock::characterize {

/// The quantisation step of readings, from the gaps between distinct values: each gap is a whole
/// number of steps. Empty if the values form no grid (they seldom repeat, or there is only one).
std::optional<double> quantisation_step(std::span<const double> readings);

}  // namespace drydock::characterize
