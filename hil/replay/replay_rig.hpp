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
#include "hil/replay/recording_file.hpp"
#include "hil/replay/rigs/rig_captures.hpp"

namespace drydock::replay {

struct RigReplayOptions {
  std::string recording;  ///< MCAP; of captures: their names, for people
  RigCaptures captures;   ///< what is played in the place of a recording; needs `rig`
  std::string rig;        ///< another rig file; empty: the recorded one
  record::Selection part;
  double speed = 0;  ///< factor on real time; 0: as fast as possible, in lockstep
  bool step = false, quiet = false;
  std::string faults;  ///< a file of blocks [[fault]]; empty: none
  host::RecordOptions record;
  host::ServeOptions serve;        ///< with speed > 0 only
  std::vector<std::string> onto;   ///< NAME=URI or "auto"; with speed > 0 only
  std::string check, update_refs;  ///< JSON files
  double tolerance = 0;            ///< relative, for check
  std::optional<std::uint64_t> refs_every;
  std::string report, json, junit;  ///< folder, file, file; empty: none
  bool expect = false;              ///< judges the rig's [[expect]]
};

/// `drydock replay` of a recording, or of captures with a rig: plays the bytes through the rig's
/// drivers and estimators.
/// Writes JSON Lines to `out` (with `quiet` the summary) and the rest to `err`; steps wait for
/// lines from `in`. Exit code: 0 there were measurements and none diverged; 1 otherwise; 2 it
/// cannot be played.
int replay_rig(const RigReplayOptions& options, std::FILE* in, std::FILE* out, std::FILE* err);

}  // namespace drydock::replay
