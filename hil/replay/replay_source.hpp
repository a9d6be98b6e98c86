#pragma once

#include <map>
#include <optional>
#include <string>

#include "drivers/recordings/record/recording.hpp"
#include "hil/replay/replay_rig.hpp"
#include "hil/replay/rigs/other_rig.hpp"

namespace drydock::replay {

/// What is played.
struct ReplaySource {
  record::Recording recording;
  std::optional<OtherRig> laid = {};                    ///< of captures: the rig that reads them
  std::map<std::string, measurement::Stamp> ends = {};  ///< of captures, by link
};

/// Opens the recording of the options, or makes one of their captures. Throws std::runtime_error
/// with one line.
ReplaySource source_of(const RigReplayOptions& options);

/// Throws std::runtime_error with the first problem of the rig file.
rig_config::Rig rig_in(const std::string& file);

}  // namespace drydock::replay
