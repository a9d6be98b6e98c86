#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/host/rig_recorder.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "drivers/recordings/record/selection.hpp"

namespace drydock::replay {

struct RigReplayOptions {
  std::string recording;  ///< MCAP
  record::Selection part;
  double speed = 0;  ///< times as fast as it was; 0: at once, in lockstep
  bool step = false, quiet = false;
  std::string faults;  ///< a file of blocks [[fault]]; empty: none
  host::RecordOptions record;
  host::ServeOptions serve;        ///< in real time only
  std::vector<std::string> onto;   ///< NAME=URI or "auto"; in real time only
  std::string check, update_refs;  ///< JSON files
  double tolerance = 0;            ///< of check, relative
  std::optional<std::uint64_t> refs_every;
};

/// Whether a file is a recording of drydock's format rather than a capture; told by its content.
bool is_recording(const std::string& path);

/// `drydock replay` of a recording: its bytes through the rig's drivers and estimators. JSON Lines
/// on `out` (with `quiet` the summary), the rest on `err`; steps wait for lines from `in`. Exit
/// code: 0 there were measurements and none diverged, 1 otherwise, 2 it cannot be played.
int replay_rig(const RigReplayOptions& options, std::FILE* in, std::FILE* out, std::FILE* err);

}  // namespace drydock::replay
