#pragma once

#include <array>
#include <optional>

#include "drivers/wire/dvl/pd0_ensemble.hpp"

namespace drydock::wire {

/// The four components over the bed in the frame of the fixed leader, with the best resolution in
/// the ensemble. It uses the high-resolution velocity, unless bottom track is there and marks the
/// component as bad.
DvlComponents finest_velocity(const Pd0Ensemble& ensemble);

/// Velocity of the instrument over the bed in its body axes, m/s (dvl_frame.hpp). The frame and the
/// attitude are those of the ensemble.
std::optional<std::array<double, 3>> velocity_frd(const Pd0Ensemble& ensemble);

}  // namespace drydock::wire
