#pragma once

#include "drivers/wire/dvl_frame.hpp"
#include "hil/sensor/dvl.hpp"

/// What the emulated heads of Teledyne's formats have in common.
namespace drydock::emulate {

/// Compass and pendulums as the head reads them: heading 0 to 360 degrees; the pendulum on the bow
/// axis reads more than Euler's pitch when the head is heeled.
wire::DvlAttitude head_attitude(const measurement::BottomVelocity& measured);

/// The head's own velocity as starboard, bow, mast, error.
wire::DvlComponents along_head_axes(const Eigen::Vector3d& frd, std::optional<double> error_mps);

/// Strength of an echo as Teledyne's heads count it, 0 without one; docs/world/ocean.md (17), (18).
std::uint8_t correlation_counts(double snr_db);
std::uint8_t amplitude_counts(double snr_db);

}  // namespace drydock::emulate
