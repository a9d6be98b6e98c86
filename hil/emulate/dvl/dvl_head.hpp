#pragma once

#include "drivers/wire/dvl/dvl_frame.hpp"
#include "hil/sensor/dvl.hpp"

/// Common parts of the emulated heads with Teledyne's formats.
namespace drydock::emulate {

/// Compass and pendulums as the head reads them. Heading is 0 to 360 degrees. The pendulum on the
/// bow axis reads more than Euler's pitch when the head is heeled.
wire::DvlAttitude head_attitude(const measurement::BottomVelocity& measured);

/// The head's own velocity as starboard, bow, mast, error.
wire::DvlComponents along_head_axes(const Eigen::Vector3d& frd, std::optional<double> error_mps);

/// Echo strength in the counts of Teledyne's heads, 0 without an echo; docs/world/ocean.md (17),
/// (18).
std::uint8_t correlation_counts(double snr_db);
std::uint8_t amplitude_counts(double snr_db);

}  // namespace drydock::emulate
