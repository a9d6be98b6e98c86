#pragma once

#include "drivers/cli/rig_recorder.hpp"
#include "drivers/cli/rig_viewer.hpp"
#include "rig_config/rig.hpp"

namespace drydock::cli {

struct DriveOptions {
  double duration_s = 0;  ///< 0: until Ctrl-C
  RecordOptions record;
  ServeOptions serve;
};

/// Runs the drivers of a rig: links in, measurements and health on the bus, all of it into a
/// recording if wanted. Returns 0, or 1 when a device was not streaming at the end or the recording
/// failed.
int drive(const rig_config::Rig& rig, const DriveOptions& options);

}  // namespace drydock::cli
