#pragma once

#include "drivers/host/follower.hpp"
#include "hil/track/dive_source.hpp"
#include "hil/track/gathered.hpp"

namespace drydock::track {

/// Plays a recording through the drivers of its rig, in virtual time. `rig_file`: a rig file in the
/// place of the recorded one, with the same devices; empty: the recorded one. `also` hears every
/// measurement; may be null. Throws std::runtime_error with one line if it cannot be played.
Gathered gather_recording(const std::string& path, const record::Selection& part,
                          const std::string& rig_file = {}, host::Follower* also = nullptr);

/// Plays the capture of one sensor through its driver. Throws std::exception with one line.
Gathered gather_capture(const DiveSource& dive, host::Follower* also = nullptr);

/// Plays captures through the devices of a rig that read them. Throws as dive_through_rig().
Gathered gather_captures(const DiveSource& dive, host::Follower* also = nullptr);

}  // namespace drydock::track
