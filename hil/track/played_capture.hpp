#pragma once

#include <vector>

#include "hil/track/capture_rig.hpp"
#include "hil/track/dive_source.hpp"

namespace drydock::track {

/// All that the driver of a capture measured, in the order of the file.
struct PlayedCapture {
  std::vector<measurement::Measurement> measurements;
  bool times_of_capture = false;   ///< else of a device's own clock, or of none
  std::vector<std::string> notes;  ///< whose clock the times are of, and what is odd about them
};

/// Plays a capture through the driver of its rig, in virtual time. `part`: its times count from the
/// first measurement. Throws std::exception with one line if it cannot be played.
PlayedCapture played_capture(const CaptureRig& rig, const record::Selection& part);

/// One line for a capture without a measurement: what to look at.
std::string silence_of(const OneCapture& capture, const CaptureRig& rig,
                       const record::Selection& part);

}  // namespace drydock::track
