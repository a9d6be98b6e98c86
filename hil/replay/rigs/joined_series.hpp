#pragma once

#include "hil/replay/rigs/joined_capture.hpp"
#include "hil/replay/rigs/rig_captures.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// Captures with one file for each series of files.
struct JoinedSeries {
  RigCaptures captures;
  std::vector<std::string> notes;
  std::vector<std::shared_ptr<const TemporaryFile>> files;  ///< that `captures` name
};

/// Makes one capture of those that are named for one device, and of those in one folder that the
/// same devices of the rig understand. Throws std::exception with one line.
JoinedSeries join_series(const rig_config::Rig& rig, const RigCaptures& captures);

}  // namespace drydock::replay
