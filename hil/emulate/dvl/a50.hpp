#pragma once

#include <array>

#include "drivers/measurement/units.hpp"
#include "hil/sensor/dvl.hpp"

/// The DVL A50 of Water Linked, whatever protocol it speaks.
namespace drydock::emulate::a50 {

/// It works at 1 MHz.
inline constexpr sensor::JanusHead head_of_an_a50{.beam_angle_rad = 22.5 * units::degree,
                                                  .shortest_range_m = 0.05,
                                                  .longest_range_m = 50,
                                                  .absorption_dbpm = 0.35};
/// The transducers (from 0) in the order of JanusHead's beams.
inline constexpr std::array<int, 4> transducers_of_beams{2, 0, 3, 1};
inline constexpr double noise_dbm = -95;
inline constexpr int most_queued_pings = 15;
inline constexpr double slowest_sound_mps = 1000, fastest_sound_mps = 2000;

}  // namespace drydock::emulate::a50
