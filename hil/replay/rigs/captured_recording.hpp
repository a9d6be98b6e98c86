#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// A capture as a recording of a rig's links. Its file is temporary, and gone already.
struct CapturedRecording {
  record::Recording recording;
  std::vector<std::string> notes;  ///< whose times it has, what in the capture cannot be read
  std::map<std::string, measurement::Stamp> ends;  ///< by link: when its capture has ended
  bool of_arrival = false;  ///< at least one capture has the times at which its bytes came
};

/// `rig`: as lay() gives it, with `file:` links alone. Each byte and frame has the time at which a
/// driver gets it when the capture is played in virtual time. Throws std::runtime_error with one
/// line if the capture cannot be read, or the recording cannot be written.
CapturedRecording record_capture(const rig_config::Rig& rig);

}  // namespace drydock::replay
