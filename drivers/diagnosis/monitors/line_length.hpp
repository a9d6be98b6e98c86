#pragma once

#include "drivers/measurement/measurement.hpp"

namespace drydock::diagnosis {

/// line_length_of a list without a satellite; with each one it is one more.
inline constexpr std::uint32_t no_satellites = 3;

/// A number that changes when a receiver says more or less than before: a fix or a satellite came
/// or went (UBX NAV-SAT: 12 bytes each). On a serial line all that follows then arrives at another
/// time. 0: the messages of this kind have one length.
inline std::uint32_t line_length_of(const measurement::Measurement& measurement) {
  if (const auto* fix = std::get_if<measurement::GnssFix>(&measurement))
    return fix->position ? 1 : 2;
  if (const auto* sky = std::get_if<measurement::GnssSatellites>(&measurement))
    return no_satellites + static_cast<std::uint32_t>(sky->satellites.size());
  return 0;
}

}  // namespace drydock::diagnosis
