#pragma once

#include "drivers/measurement/units.hpp"
#include "hil/sensor/dvl.hpp"

namespace drydock::emulate {

/// The DVL1000 works at 1 MHz.
inline constexpr sensor::JanusHead dvl1000{.beam_angle_rad = 25 * units::degree,
                                           .shortest_range_m = 0.2,
                                           .longest_range_m = 75,
                                           .absorption_dbpm = 0.35};

}  // namespace drydock::emulate
