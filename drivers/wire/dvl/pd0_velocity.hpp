#pragma once

#include <array>
#include <optional>

#include "drivers/wire/dvl/pd0_ensemble.hpp"

namespace drydock::wire {

/// The four components over the bed in the frame of the fixed leader, each as fine as the ensemble
/// has it: high resolution where bottom track, if there is one, does not call it bad.
DvlComponents finest_velocity(const Pd0Ensemble& ensemble);

/// Velocity of the instrument over the bed in its body axes, m/s (dvl_frame.hpp), from the frame
/// and with the attitude that the ensemble itself tells.
std::optional<std::array<double, 3>> velocity_frd(const Pd0Ensemble& ensemble);

}  // namespace drydock::wire
