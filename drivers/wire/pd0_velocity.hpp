#pragma once

#include <array>
#include <optional>

#include "drivers/wire/pd0_ensemble.hpp"

namespace drydock::wire {

/// The four components over the bed in the frame of the fixed leader, each as fine as the ensemble
/// has it: high resolution where bottom track, if there is one, does not call it bad.
std::array<std::optional<double>, 4> finest_velocity(const Pd0Ensemble& ensemble);

/// Velocity of the instrument over the bed in its body axes (x along the ship's bow as the heading
/// alignment says, y starboard, z down), m/s, from whatever frame the ensemble is in:
///   beam        Janus geometry; one bad beam of four is bridged where the set-up allows it
///   instrument  turned by the heading alignment
///   ship        as it is, or levelled back to the body with pitch and roll when tilts were used
///   earth       turned back with heading, pitch and roll of the variable leader
/// The pitch sensor reads the tilt of the bow axis, so the Euler pitch is atan(tan(pitch)
/// cos(roll)). Source: Teledyne RDI, ADCP Coordinate Transformation, P/N 951-6079-00. Empty without
/// bottom lock, for an upward-facing instrument, and where an angle that the way needs is missing.
std::optional<std::array<double, 3>> velocity_frd(const Pd0Ensemble& ensemble);

}  // namespace drydock::wire
