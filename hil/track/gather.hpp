#pragma once

#include "drivers/decode/replay.hpp"
#include "drivers/host/follower.hpp"
#include "drivers/recordings/record/selection.hpp"
#include "hil/replay/rigs/rig_captures.hpp"
#include "hil/track/gathered.hpp"

namespace drydock::track {

/// Plays a recording through the drivers of its rig, in virtual time. `rig_file`: a rig file in the
/// place of the recorded one, with the same devices; empty: the recorded one. `also` hears every
/// measurement; may be null. Throws std::runtime_error with one line if it cannot be played.
Gathered gather_recording(const std::string& path, const record::Selection& part,
                          const std::string& rig_file = {}, host::Follower* also = nullptr);

/// Plays a capture of one sensor through its driver. `rig_file`: as rig_of_capture() takes it.
/// Throws std::exception with one line.
Gathered gather_capture(const decode::ReplayOptions& capture, const record::Selection& part = {},
                        const std::string& rig_file = {}, host::Follower* also = nullptr);

/// Plays captures through the devices of a rig that read them (replay/rigs/laid_capture.hpp).
/// Throws std::invalid_argument where it is not plain which does, std::runtime_error where one
/// cannot be read; both have one line.
Gathered gather_captures(const replay::RigCaptures& captures, const std::string& rig_file,
                         const record::Selection& part = {}, host::Follower* also = nullptr);

}  // namespace drydock::track
