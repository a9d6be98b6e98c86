#pragma once

#include <string>

#include "hil/track/track.hpp"
#include "hil/twin/rig_text.hpp"

namespace drydock::twin {

/// Where a twin's rig file comes from: its text, its folder and the files that it names.
struct RigOrigin {
  std::string text, folder;
  std::map<std::string, std::string> files;  ///< as TwinRig::files
};

/// The rig of a recording (or the one that takes its place) or of a capture; copies the files that
/// it names into `folder`/files. Throws std::exception with one line.
RigOrigin copy_rig_of(const track::TrackOptions& source, measurement::Kind capture_kind,
                      const std::string& folder);

}  // namespace drydock::twin
