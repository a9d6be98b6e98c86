#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/decode/replay.hpp"
#include "drivers/recordings/record/selection.hpp"
#include "hil/replay/rigs/captured_recording.hpp"
#include "hil/replay/rigs/other_rig.hpp"
#include "hil/replay/rigs/rig_captures.hpp"

namespace drydock::track {

/// What a command that needs a whole dive reads: a recording, a capture, or several.
struct DiveSource {
  decode::ReplayOptions source;  ///< its `capture` names the file; the rest is for captures
  /// Captures that the devices of `rig` read, or, without it, that one sensor made one after the
  /// other; empty: `source` names the only file.
  std::vector<replay::RigCaptures::File> captures = {};
  std::string rig;         ///< a rig file in the place of the recorded one; empty: recorded
  record::Selection part;  ///< of a recording
};

bool is_recording(const DiveSource& dive);

/// True if several devices of its rig may read it.
bool goes_through_rig(const DiveSource& dive);

/// Captures as a recording of the rig that reads them.
struct DiveThroughRig {
  replay::OtherRig read_by;  ///< with who reads what, and what is left out
  replay::CapturedRecording made;
  std::string shown;  ///< the names of the captures
};

/// Throws std::invalid_argument where it is not plain which device reads which capture,
/// std::runtime_error where one cannot be read; both have one line.
DiveThroughRig dive_through_rig(const DiveSource& dive);

/// The capture of one sensor.
struct OneCapture {
  decode::ReplayOptions how;
  std::string shown;                                       ///< its name, or those of its files
  std::vector<std::string> notes = {};                     ///< how its files follow each other
  std::shared_ptr<const replay::TemporaryFile> file = {};  ///< of several: all of them
};

/// Throws std::exception with one line.
OneCapture one_capture(const DiveSource& dive);

}  // namespace drydock::track
