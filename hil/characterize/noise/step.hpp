#pragma once

#include <optional>
#include <span>

namespace drydock::characterize {

/// The step in which readings come, from the gaps between the values that occur: each is a whole
/// number of steps. Empty: they fill no grid (values seldom repeat, or one alone occurs).
std::optional<double> quantisation_step(std::span<const double> readings);

}  // namespace drydock::characterize
