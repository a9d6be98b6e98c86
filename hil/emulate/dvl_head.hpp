#pragma once

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/dvl_frame.hpp"

/// What the emulated heads of Teledyne's formats have in common.
namespace drydock::emulate {

inline constexpr double dvl_sound_speed_mps = 1490;
inline constexpr double dvl_salinity_ppt = 35;

/// Compass and pendulums as the head reads them: heading 0 to 360 degrees; the pendulum on the bow
/// axis reads more than Euler's pitch when the head is heeled.
wire::DvlAttitude head_attitude(const measurement::BottomVelocity& measured);

/// The head's own velocity as starboard, bow, mast, error.
wire::DvlComponents along_head_axes(const Eigen::Vector3d& frd, double error_mps);

}  // namespace drydock::emulate
